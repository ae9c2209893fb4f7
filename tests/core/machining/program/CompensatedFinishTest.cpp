// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Finishing with nose compensation, in the forms that docs/programs.md advises.
#include "TestClass.h"
#include "machining/program/ProgramInterpreter.h"
#include "machining/program/ProgramSimulation.h"
#include "machining/section/SectionSource.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr StockCylinder kFinishedBar{40.0, 100.0, 0.0};
constexpr double kFinishNose = 0.8;  // mm

// Returns the volume that a chamfer of 1 mm, a shaft of Ø20 and 20 mm length and a shoulder take away, mm³. The nose
// leaves its fillet in the corner.
double shaftVolume() {
  const double fillet = kFinishNose * kFinishNose * (1.0 - 0.25 * M_PI);
  const double centroid = 10.0 + (10.0 - 3.0 * M_PI) / (12.0 - 3.0 * M_PI) * kFinishNose;
  const double chamfer = 0.5 * 2.0 * M_PI * (10.0 - 1.0 / 3.0);
  return M_PI * (400.0 - 100.0) * 20.0 + chamfer - 2.0 * M_PI * centroid * fillet;
}

}  // namespace

class CompensatedFinishTest : public QObject {
  Q_OBJECT

 private slots:
  void cutsTheContour_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<bool>("isFanuc");
    const QString head = "G18 G21 G90 G7 G95 G97\nT1 M6 G43\nS900 M3\n", in = "G0 X12 Z3\nG42 G1 X16 Z1 F0.1\n",
                  contour = "X20 Z-1\nZ-20\nX44\n", out = "G40 G0 X60\n";
    QTest::newRow("a call after G71") << "O1 sub\nG0 X16 Z1\nG1 " + contour + "O1 endsub\nO2 sub\n" + in + contour +
                                             out + "O2 endsub\n" + head +
                                             "G0 X44 Z3\nG71 Q1 X44 Z3 D0.3 I2 R0.5 F0.25\nG0 X44 Z5\nO2 call\nM2\n"
                                      << false;
    QTest::newRow("moves written out") << head + in + contour + out + "M2\n" << false;
    QTest::newRow("G42 in the contour of a Fanuc")
        << QString(
               "%\nO1\nG21 G99 G97\nT0101\nS900 M3\nG0 X44. Z3.\nG71 U2. R0.5\nG71 P10 Q20 U0.6 W0.1 F0.25\n"
               "N10 G42 G0 X16. Z1.\nG1 X20. Z-1. F0.1\nZ-20.\nN20 X44.\nG70 P10 Q20\nG40 G0 X60. Z5.\nM30\n%\n")
        << true;
  }
  void cutsTheContour() {
    QFETCH(QString, text);
    QFETCH(bool, isFanuc);
    const ProgramDialect dialect = isFanuc ? ProgramDialect::Fanuc : ProgramDialect::LinuxCnc;
    ProgramSetup setup = usualSetup(dialect, kFinishedBar, 20.0, 0.0);
    setup.tools = readToolTable(isFanuc ? "T1 D1.6 Q3\n" : "T1 D1.6 Q2\n").value();
    const auto path = runProgram(text.toStdString(), setup);
    QVERIFY2(path, path ? "" : path.error().arguments.at(2).c_str());
    QVERIFY(path->notes.empty());
    ProgramSimulation simulation(TurnedProfile(kFinishedBar, 0.013), *path, setup);
    QVERIFY(simulation.run({}));
    QCOMPARE(simulation.collisionCount(), std::size_t{0});
    const double removed = kFinishedBar.volume() - simulation.part().section()->section().volume();
    QVERIFY2(std::abs(removed / shaftVolume() - 1.0) < 1e-6, qPrintable(QString::number(removed, 'f', 4)));
  }
};

HANDWHEEL_TEST(CompensatedFinishTest)
#include "CompensatedFinishTest.moc"
