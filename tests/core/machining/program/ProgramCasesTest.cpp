// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Whole programs of a school's lathe, with volumes and forces that were computed by hand.
#include "TestClass.h"
#include "machining/lathe/LatheJson.h"
#include "machining/program/ProgramInterpreter.h"
#include "machining/program/ProgramSimulation.h"
#include "machining/section/SectionOutline.h"
#include "machining/section/SectionSource.h"

#include <QtTest>
#include <cmath>

namespace {

using namespace handwheel;

constexpr StockCylinder kBarOfCases{40.0, 100.0, 0.0};

double discVolume(double diameter, double length) {
  return 0.25 * M_PI * diameter * diameter * length;
}

struct CaseResult {
  double removed = 0.0;  // mm³
  std::size_t collisions = 0, notes = 0;
  TurnedSection section;
  std::size_t pieces = 0;
  std::vector<TurningPass> passes;
};

CaseResult runCase(const std::string& text, ProgramDialect dialect, double nose, const std::string& table) {
  ProgramSetup setup = usualSetup(dialect, kBarOfCases, 20.0, nose);
  if (!table.empty()) setup.tools = readToolTable(table, shippedLatheTools(), dialect).value();
  const auto path = runProgram(text, setup);
  if (!path) return {};
  ProgramSimulation simulation(TurnedProfile(kBarOfCases, 0.013), *path, setup);
  simulation.run({});
  CaseResult result;
  result.collisions = simulation.collisionCount();
  result.notes = simulation.notes().size();
  result.section = simulation.part().section() ? simulation.part().section()->section()
                                               : SectionSource::fitted(simulation.part())->section();
  result.removed = discVolume(40, 100) - result.section.volume();
  result.pieces = result.section.pieces().size();
  result.passes = simulation.takePasses();
  return result;
}

// Returns what a nose leaves in the middle of a face if its tip goes to the axis: a point below its rounding.
double pipVolume(double nose) {
  // 2π ∫ r (R - √(R² - (R - r)²)) dr from 0 to R
  const double cube = nose * nose * nose;
  return 2.0 * M_PI * cube * (0.5 - 0.25 * M_PI + 1.0 / 3.0);
}

const std::string kHead = "G18 G21 G7 G40 G90 G95 F0.15 S1000 M3\n";

class ProgramCasesTest : public QObject {
  Q_OBJECT

 private slots:
  void volumes_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isFanuc");
    QTest::addColumn<double>("nose");
    QTest::addColumn<QString>("table");
    QTest::addColumn<double>("volume");
    const auto add = [](const char* name, const std::string& text, bool isFanuc, double nose, const char* table,
                        double volume) {
      QTest::addRow("%s", name) << QString::fromStdString(text) << isFanuc << nose << QString(table) << volume;
    };
    const double face = discVolume(40, 1);
    add("a face by a point", kHead + "G0 X44 Z-1\nG1 X0\nG0 Z2\nG0 X60\nM2\n", false, 0.0, "", face);
    add("a face by a nose", kHead + "G0 X44 Z-1\nG1 X-0.8\nG0 Z2\nG0 X60\nM2\n", false, 0.4, "", face);
    add("a face from the middle", kHead + "G0 X-0.8 Z2\nG1 Z-1\nX44\nG0 X60 Z5\nM2\n", false, 0.4, "", face);
    add("a face by an insert", kHead + "T1 M6 G43\nS1000 M3\nG0 X44 Z-1\nG1 X-1.6\nG0 Z2\nG0 X60\nM2\n", false, 0.0,
        "T1 P1 X0 Z0 Q2 ;right-roughing\n", face);
    add("three faces of 1.5 mm",
        kHead + "G0 X44 Z-1.5\nG1 X0\nG0 Z2\nX44\nZ-3\nG1 X0\nG0 Z2\nX44\nZ-4.5\nG1 X0\nG0 Z2\nX60\nM2\n", false, 0.0,
        "", discVolume(40, 4.5));
    add("a boss", kHead + "G0 X44 Z-3\nG1 X20\nG0 Z2\nX60\nM2\n", false, 0.0, "",
        discVolume(40, 3) - discVolume(20, 3));
    add("a face and a shoulder", kHead + "G0 X44 Z-1\nG1 X0\nG0 Z2\nX30\nG1 Z-31\nX42\nG0 X60 Z5\nM2\n", false, 0.0, "",
        face + discVolume(40, 30) - discVolume(30, 30));
    // A taper from Ø20 to Ø30 over 20 mm, and a recess behind it whose walls are at 45°.
    add("a taper and a recess",
        kHead + "G0 X20 Z2\nG1 Z0\nX30 Z-20\nZ-30\nX20 Z-35\nZ-40\nX30 Z-45\nZ-50\nX42\nG0 X60 Z5\nM2\n", false, 0.0,
        "",
        discVolume(40, 50) - M_PI / 3.0 * 20.0 * (100.0 + 150.0 + 225.0) - discVolume(30, 15) -
            2.0 * M_PI / 3.0 * 5.0 * (100.0 + 150.0 + 225.0) - discVolume(20, 5));
    // A ball of Ø20 at the end, a neck of Ø10 from where it is as thick: 8.660254 mm behind its middle.
    const double depth = std::sqrt(75.0);
    add("a ball", kHead + "G0 X0 Z2\nG1 Z0\nG3 X10 Z-18.660254 K-10\nG1 Z-30\nX42\nG0 X60 Z5\nM2\n", false, 0.0, "",
        discVolume(40, 30) - M_PI * (2000.0 / 3.0 + 100.0 * depth - 25.0 * depth) - discVolume(10, 30.0 - 18.660254));
    // A blade of 3 mm with corners of 0.2 mm, which leave 0.0086 mm² each.
    const double corner = 0.04 * (1.0 - 0.25 * M_PI) * 2.0 * M_PI * 15.0447;
    add("a groove by a blade", kHead + "T1 M6 G43\nS1000 M3\nG0 X44 Z-20\nG1 X30\nG0 X60\nM2\n", false, 0.0,
        "T1 P1 X0 Z0 Q2 ;parting-3\n", discVolume(40, 3) - discVolume(30, 3) - 2.0 * corner);
    add("G75 by a blade",
        "%\nO1\nG21 G99\nT0101\nG97 S1000 M3\nG0 X44. Z-20.\nG75 R0.5\nG75 X30. Z-17.5 P2000 Q2500 F0.1\nG0 "
        "X60.\nM30\n",
        true, 0.0, "T1 P1 X0 Z0 Q3 ;parting-3\n", discVolume(40, 5.5) - discVolume(30, 5.5) - 2.0 * corner);
    add("G72 by a point",
        "%\nO0001\nG21 G18 G40 G99\nT0101\nG50 S2000\nG97 S1000 M3\nG0 X42. Z2.\nG72 W1.5 R0.5\nG72 P10 Q20 U0 W0 "
        "F0.2\n"
        "N10 G0 Z-10.\nG1 X24. F0.1\nZ-4.\nX10.\nN20 Z2.\nG70 P10 Q20\nM30\n%\n",
        true, 0.0, "", discVolume(40, 10) - discVolume(24, 6) - discVolume(10, 4));
    // The tool feeds in at the axis, and faces outward: no drill.
    add("a face from the axis", kHead + "G0 X0 Z2\nG1 Z-0.5\nX44\nG0 Z5\nM2\n", false, 0.0, "", discVolume(40, 0.5));
    add("a face from the axis by a nose", kHead + "G0 X0 Z2\nG1 Z-3\nX44\nG0 Z5\nM2\n", false, 0.8, "",
        discVolume(40, 3) - pipVolume(0.8));
    add("a face from beyond the axis", kHead + "G0 X-1.6 Z2\nG1 Z-1\nX44\nG0 Z5\nM2\n", false, 0.4, "", face);
    const double chamfered = discVolume(40, 20) - discVolume(24, 17.5) - M_PI / 3.0 * 2.0 * (100.0 + 120.0 + 144.0);
    add("a contour from the axis", kHead + "G0 X0 Z2\nG1 Z-0.5\nX20\nX24 Z-2.5\nZ-20\nX42\nG0 Z5\nM2\n", false, 0.0, "",
        chamfered);
    add("G71 and G70 of a contour from the axis",
        "%\nO0002\nG21 G18 G40 G99\nT0101\nG97 S1000 M3\nG0 X42. Z2.\nG71 U1.5 R0.5\nG71 P10 Q20 U0.4 W0.2 F0.2\n"
        "N10 G0 X0.\nG1 Z-0.5 F0.1\nX20.\nX24. Z-2.5\nZ-20.\nN20 X42.\nG70 P10 Q20\nM30\n%\n",
        true, 0.0, "", chamfered);
    // The middle of the face falls off where the nose touches the axis, and is not struck on the way back.
    for (const double nose : {0.4, 0.8, 1.0})
      add(qPrintable(QString("to the axis and back by a nose of %1").arg(nose)),
          kHead + "G0 X48 Z-1\nG1 X0\nG0 Z2\nM2\n", false, nose, "", face - pipVolume(nose));
    add("to the axis and back by an insert of 0.4", kHead + "T1 M6 G43\nG0 X48 Z-1\nS900 M3\nG1 X0 F0.1\nG0 Z2\nM2\n",
        false, 0.0, "T1 P1 X0 Z0 ;facing\n", face - pipVolume(0.4));
    add("to the axis and back by an insert of 0.8", kHead + "T1 M6 G43\nG0 X48 Z-1\nS900 M3\nG1 X0 F0.1\nG0 Z2\nM2\n",
        false, 0.0, "T1 P1 X0 Z0 ;right-roughing\n", face - pipVolume(0.8));
    // Faces in many small moves are those of one: in a loop, and along a dome of R40 by chords of an arc.
    add("a face in a loop",
        kHead + "G0 X42 Z-2\n#1=41.8\no1 while [#1 GE -0.1]\nG1 X#1\n#1=[#1-0.2]\no1 endwhile\nG0 Z1\nM2\n", false, 0.0,
        "", discVolume(40, 2));
    const double dome = M_PI * 400.0 * 41.0 - 2.0 / 3.0 * M_PI * (64000.0 - std::pow(1200.0, 1.5));
    add("a dome", kHead + "G0 X42 Z-6.358984\nG1 X40\nG2 X0 Z-1 R40\nG0 Z1\nM2\n", false, 0.0, "", dome);
    add("a dome in chords",
        kHead +
            "G0 X42 Z-6.358984\nG1 X40\n#1=19.96\no1 while [#1 GE -0.01]\n"
            "G1 X[2*#1] Z[SQRT[1600-#1*#1]-41]\n#1=[#1-0.04]\no1 endwhile\nG0 Z1\nM2\n",
        false, 0.0, "", dome);
    // A shoulder is faced again, between two samples of the display.
    add("a shoulder by 4 µm", kHead + "G0 X30 Z1\nG1 Z-29.995\nX42\nG0 Z-29.99\nX30\nG1 Z-29.999\nX42\nG0 Z1\nM2\n",
        false, 0.0, "", discVolume(40, 29.999) - discVolume(30, 29.999));
    // A drill of 12 mm with a point of 118°, 3.6052 mm high, after a face of 1 mm.
    add("faced, then drilled",
        kHead +
            "T1 M6 G43\nS1200 M3\nG0 X44 Z-1\nG1 X-1.6 F0.2\nG0 Z2\nX44\nT5 M6 G43\nS500 M3\nG0 X0 Z5\nG1 Z-30 "
            "F0.12\nG0 Z5\nM2\n",
        false, 0.0, "T1 P1 X0 Z0 ;right-roughing\nT5 P5 X0 Z0 ;drill-12\n",
        face + discVolume(12, 29.0 - 3.6052) + discVolume(12, 3.6052) / 3.0);
  }
  void volumes() {
    QFETCH(QString, text);
    QFETCH(bool, isFanuc);
    QFETCH(double, nose);
    QFETCH(QString, table);
    QFETCH(double, volume);
    const CaseResult result = runCase(text.toStdString(), isFanuc ? ProgramDialect::Fanuc : ProgramDialect::LinuxCnc,
                                      nose, table.toStdString());
    QCOMPARE(result.collisions, std::size_t{0});
    QCOMPARE(result.notes, std::size_t{0});
    QVERIFY2(std::abs(result.removed / volume - 1.0) < 1e-5,
             qPrintable(QString("%1 instead of %2").arg(result.removed, 0, 'f', 4).arg(volume, 0, 'f', 4)));
    QCOMPARE(result.pieces, std::size_t{1});
    // The part is one outline, and the passes cut it once more.
    QVERIFY(bool(outlineOf(result.section, 1e-3, 0.0)));
    TurnedProfile again(kBarOfCases, 0.013);
    for (std::size_t i = 0; i < result.passes.size(); ++i)
      cut(again, std::make_shared<const TurningPass>(result.passes[i]), static_cast<std::uint32_t>(i));
    QVERIFY(again.section() && std::abs(again.section()->section().volume() - result.section.volume()) < 1e-6);
  }
};

}  // namespace

HANDWHEEL_TEST(ProgramCasesTest)
#include "ProgramCasesTest.moc"
