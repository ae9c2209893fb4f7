// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/CutLoads.h"

#include "TestClass.h"
#include "document/workpiece/ProgramTrial.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "machining/lathe/LatheJson.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

constexpr StockCylinder kLoadedBar{40.0, 100.0, 0.0}, kSlenderBar{20.0, 60.0, 0.0};
constexpr double kLoadSpacing = 0.013, kTurnsPerMinute = 600.0;  // mm, r/min
constexpr double kEfficiency = 0.8;                              // share of the motor's power at the cut

const WorkMaterial& steel() {
  return WorkMaterials::standard().called("medium-carbon-steel");
}

std::unique_ptr<KienzleModel> lawOfSteel() {
  return kienzleModel(steel(), {});
}

WorkpieceSnapshot loadedBar(const StockCylinder& stock = kLoadedBar) {
  WorkpieceSnapshot work;
  work.stock = stock;
  return work;
}

// Returns a workpiece after a program with a nose. Tools 2 and 3 are drills of 20 and 10 mm, as bodies or noses.
WorkpieceSnapshot after(WorkpieceSnapshot work, const std::string& text, double nose = 0.8, bool hasBody = false) {
  ProgramSetup setup;
  setup.standard = {nose, outsideOrientation(setup.dialect), {0, 0}};
  setup.reference = {120.0, 100.0};
  const LatheTools tools = shippedLatheTools();
  for (const auto& [number, id] : {std::pair(2, "drill-20"), std::pair(3, "drill-10")}) {
    setup.tools[number] = programToolOf(toolNamed(tools, id), setup.dialect);
    if (!hasBody) setup.tools[number].body = nullptr;
  }
  const auto trial = ProgramTrial::run(work, text, setup, kLoadSpacing);
  if (trial) work.part = (*trial)->part();
  return work;
}

LoadPeaks peaksOf(const WorkpieceSnapshot& work, const TurnedPart* before = nullptr) {
  return loadPeaks(work, before, steel(), {}).value();
}

// Along the bar from its upper end, so deep, in so many moves.
TurningPass alongTheBar(double depth, double feed, int moves) {
  TurningPass pass;
  pass.noseRadius = 0.8;
  for (int i = 0; i <= moves; ++i) {
    pass.path.emplace_back(20.0 - depth + pass.noseRadius, 105.0 - 60.0 * i / moves);
    pass.times.push_back(60.0 * i / moves / (feed * kTurnsPerMinute / 60.0));
    pass.speeds.push_back(kTurnsPerMinute);
  }
  return pass;
}

WorkpieceSnapshot turnedBy(std::vector<TurningPass> passes) {
  WorkpieceSnapshot work = loadedBar();
  work.part = withPasses(work, std::move(passes), kLoadSpacing);
  return work;
}

}  // namespace

// The loads of passes.
class CutLoadsTest : public QObject {
  Q_OBJECT

 private slots:
  // A cut of constant depth by hand: the force of the law at the diameter of the bar, by few and by many moves.
  void findsTheDepthAndTheFeed_data() {
    QTest::addColumn<int>("moves");
    QTest::newRow("one move") << 1;
    QTest::newRow("some moves") << 60;
    QTest::newRow("a recording") << 18'000;  // 1 kHz
  }
  void findsTheDepthAndTheFeed() {
    QFETCH(int, moves);
    const LoadPeaks peaks = peaksOf(turnedBy({alongTheBar(2.0, 0.2, moves)}));
    const CutConditions cut{2.0, 0.2, M_PI * 40.0 * kTurnsPerMinute / 1000.0};
    const CutForces expected = lawOfSteel()->at(cut);
    QVERIFY2(std::abs(peaks.force / expected.norm() - 1.0) < 0.08, qPrintable(QString::number(peaks.force)));
    QVERIFY(std::abs(kEfficiency * peaks.power / cuttingPower(expected, cut) - 1.0) < 0.08);
  }

  // The second pass takes 3 mm, more than the others.
  void deepestPassCounts() {
    const LoadPeaks peaks =
        peaksOf(turnedBy({alongTheBar(1.0, 0.2, 60), alongTheBar(4.0, 0.2, 60), alongTheBar(4.5, 0.2, 60)}));
    QVERIFY(std::abs(peaks.force / lawOfSteel()->at({3.0, 0.2, 75.0}).norm() - 1.0) < 0.08);
  }

  void nothingCutsNothing() {
    for (const WorkpieceSnapshot& work : {loadedBar(), turnedBy({alongTheBar(-1.0, 0.2, 60)})}) {
      const LoadPeaks peaks = peaksOf(work);
      QVERIFY(peaks.force == 0.0 && peaks.power == 0.0);
    }
  }

  // A rapid move through the work is heavier than a cut, and a spindle at rest or nonsense gives finite loads.
  void crashesGiveFiniteLoads() {
    const LoadPeaks rapid = peaksOf(after(loadedBar(), "G7 G97 S600 M3\nG0 X36 Z3\nZ-30\nM2\n"));
    QVERIFY(std::isfinite(rapid.force) && rapid.force > lawOfSteel()->at({2.0, 0.2, 120.0}).norm());
    for (const double speed : {0.0, -500.0, std::nan("")}) {
      TurningPass pass = alongTheBar(2.0, 0.2, 10);
      pass.speeds.assign(pass.speeds.size(), speed);
      const LoadPeaks odd = peaksOf(turnedBy({pass}));
      QVERIFY(std::isfinite(odd.force) && std::isfinite(odd.power));
    }
  }

  void canBeCancelled() {
    JobState state;
    state.cancelled = true;
    QVERIFY(!loadPeaks(turnedBy({alongTheBar(2.0, 0.2, 1000)}), nullptr, steel(), {}, Progress(state)));
  }

  // The control holds the speed at the tip, 18 mm over the axis: 150000 / (36 pi) r/min. A cut of 2 mm at 0.2 mm needs
  // the same force and power at that spindle speed without G96.
  void surfaceSpeedIsThatOfTheTip() {
    const std::string speed = std::to_string(150000.0 / (36.0 * M_PI));
    const auto held = after(loadedBar(), "G7 G95 F0.2 G96 S150 D3000 M3\nG0 X36 Z3\nG1 Z-30\nG0 X50\nM2\n");
    const auto fixed = after(loadedBar(), "G7 G95 F0.2 G97 S" + speed + " M3\nG0 X36 Z3\nG1 Z-30\nG0 X50\nM2\n");
    for (const WorkpieceSnapshot& work : {held, fixed}) {
      const LoadPeaks peaks = peaksOf(work);
      const CutForces forces = lawOfSteel()->at({2.0, 0.2, 150.0});
      QVERIFY2(std::abs(peaks.force / forces.norm() - 1.0) < 2e-3, qPrintable(QString::number(peaks.force)));
      QVERIFY(std::abs(kEfficiency * peaks.power / (forces.cutting * 150.0 / 60000.0) - 1.0) < 2e-3);
    }
  }

  // The same drill as in ForceLawsTest, 30 mm deep: 25.752 N·m, 1.3484 kW and 2207.4 N, of which the nose of a tool or
  // the body of a drill makes no difference. In a hole of 10 mm three quarters of the torque remain.
  void aDrillHasTheForcesOfADrill() {
    const std::string drill = "G7 G95 F0.2 G97 S500 M3\nT2 M6 M3\nG0 X0 Z3\nG1 Z-30\nG0 Z5\n";
    const auto check = [](const LoadPeaks& peaks, double share) {
      const DrillPeaks& drilling = peaks.drilling;
      return drilling.diameter == 20.0 && std::abs(drilling.torque / (share * 25.752) - 1.0) < 0.02 &&
             std::abs(drilling.power / (share * 1.3484) - 1.0) < 0.02 &&
             std::abs(drilling.power / (kEfficiency * peaks.power) - 1.0) < 1e-9 && drilling.thrust == peaks.force;
    };
    for (const bool hasBody : {false, true}) {
      const LoadPeaks peaks = peaksOf(after(loadedBar(), drill + "M2\n", 0.8, hasBody));
      QVERIFY2(check(peaks, 1.0), qPrintable(QString::number(peaks.drilling.torque)));
      QVERIFY(std::abs(peaks.drilling.thrust / 2207.4 - 1.0) < 0.02);
      const std::string small = "G7 G95 F0.2 G97 S500 M3\nT3 M6 M3\nG0 X0 Z3\nG1 Z-40\nG0 Z5\n";
      const WorkpieceSnapshot pilot = after(loadedBar(), small + "M2\n", 0.8, hasBody);
      const LoadPeaks first = peaksOf(pilot);
      const LoadPeaks both = peaksOf(after(pilot, drill + "M2\n", 0.8, hasBody), pilot.part.get());
      QVERIFY(first.drilling.diameter == 10.0 && first.drilling.torque < 0.3 * 25.752);
      QVERIFY2(check(both, 0.75), qPrintable(QString::number(both.drilling.torque)));
    }
    const auto turned = after(loadedBar(), "G7 G95 F0.2 G97 S500 M3\nG0 X36 Z3\nG1 Z-30\nM2\n");
    QCOMPARE(peaksOf(turned).drilling.diameter, 0.0);
  }

  // Kienzle's law, Fc = kc1.1 b h^(1 - mc), for the chip of a pass: a sharp tool with flanks of 30° that was fed from
  // the depth t0 straight in to t cuts on b = 2 t / cos 30° and takes (t² - t0²) tan 30°.
  void theChipOfAThread_data() {
    QTest::addColumn<QString>("passes");
    QTest::addColumn<double>("before");
    QTest::addColumn<double>("depth");
    QTest::newRow("the first pass") << "G0 X9.5 Z5\nG33 Z-20 K2.5\n" << 0.0 << 0.5;
    QTest::newRow("the second pass") << "G0 X9.7 Z5\nG33 Z-20 K2.5\nG0 X12\nZ5\nX9.4\nG33 Z-20 K2.5\n" << 0.3 << 0.6;
    // A thread as deep as an existing one, elsewhere.
    QTest::newRow("another thread") << "G0 X9.8 Z5\nG33 Z-20 K2.5\nG0 X12\nZ5\nX9.6\nG33 Z-20 K2.5\nG0 X12\nZ-22\n"
                                       "X9.6\nG33 Z-50 K2.5\n"
                                    << 0.0 << 0.4;
  }
  void theChipOfAThread() {
    QFETCH(QString, passes);
    QFETCH(double, before);
    QFETCH(double, depth);
    const std::string text = "G21 G18 G8 G97 S300 M3\nG0 X12 Z5\n" + passes.toStdString() + "G0 X15\nM2\n";
    const double width = 2.0 * depth / std::cos(M_PI / 6.0);
    const double area = (depth * depth - before * before) * std::tan(M_PI / 6.0);
    const double force = 1500.0 * width * std::pow(area / width, 1.0 - 0.22);
    const double speed = M_PI * 20.0 * 300.0 / 1000.0;  // m/min
    const LoadPeaks peaks = peaksOf(after(loadedBar(kSlenderBar), text, 0.0));
    QVERIFY2(std::abs(kEfficiency * peaks.power / (force * speed / 60000.0) - 1.0) < 0.01,
             QByteArray::number(peaks.power));
  }

  // A pass as deep as the one before takes nothing, in the same groove.
  void aSpringPassHasNoForce() {
    const std::string text = "G21 G18 G8 G97 S300 M3\nG0 X9.5 Z5\nG33 Z-20 K2.5\nG0 X15\nM2\n";
    const WorkpieceSnapshot first = after(loadedBar(kSlenderBar), text, 0.0);
    QVERIFY(peaksOf(first).power > 0.0);
    const WorkpieceSnapshot second = after(first, text, 0.0);
    QVERIFY(second.part->passes.size() > first.part->passes.size());
    QCOMPARE(peaksOf(second, first.part.get()).power, 0.0);
  }
};

HANDWHEEL_TEST(CutLoadsTest)
#include "CutLoadsTest.moc"
