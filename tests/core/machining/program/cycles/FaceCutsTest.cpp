// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/FaceCuts.h"

#include "TestClass.h"
#include "machining/program/ProgramInterpreter.h"
#include "machining/program/ProgramSimulation.h"
#include "machining/program/cycles/CycleProgram.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

constexpr double kFaceSpacing = 0.013;  // mm

// A shoulder of 30 and 40 mm, 60 mm long.
TargetProfile facedShoulder() {
  return TargetProfile::make({{{18, -60}, {18, -30}}, {{18, -30}, {15, -30}}, {{15, -30}, {15, 0}}}).value();
}

// The heights of the tip over the face at which moves feed to or beyond the axis, or to the hole.
std::vector<double> facingHeights(const std::vector<ToolMove>& moves, double hole) {
  std::vector<double> heights;
  for (const ToolMove& move : moves)
    if (move.kind == ToolMove::Kind::Feed && move.to.x() < hole) heights.push_back(move.to.y());
  return heights;
}

}  // namespace

// The end of a bar that stands over the face of its target.
class FaceCutsTest : public QObject {
  Q_OBJECT

 private slots:
  // The part ends at the face of the target, to a sample: nothing is above it, and below it is the cylinder of ⌀30.
  void theFaceIsCut_data() {
    QTest::addColumn<double>("above");
    QTest::addColumn<double>("hole");
    QTest::addColumn<bool>("isFanuc");
    for (const double above : {0.2, 1.0, 30.0}) {
      for (const double hole : {0.0, 6.0}) {
        QTest::addRow("%g mm, hole of %g mm, LinuxCNC", above, hole) << above << hole << false;
        QTest::addRow("%g mm, hole of %g mm, Fanuc", above, hole) << above << hole << true;
      }
    }
  }
  void theFaceIsCut() {
    QFETCH(double, above);
    QFETCH(double, hole);
    QFETCH(bool, isFanuc);
    const ProgramDialect dialect = isFanuc ? ProgramDialect::Fanuc : ProgramDialect::LinuxCnc;
    const TargetProfile target = facedShoulder();
    const StockCylinder stock{40.0, 100.0 + above, 0.0};
    TurnedProfile bar(stock, kFaceSpacing);
    for (std::size_t i = 0; i < bar.size(); ++i) bar.limitInner(i, hole);
    CycleTask task{target, stock, bar, -100.0, 20.0};
    task.allowance = above;
    const CycleSettings settings;
    const auto program = cycleProgram(task, dialect, settings);
    QVERIFY2(bool(program), program ? "" : program.error().arguments.front().c_str());
    const ProgramSetup setup = [&] {
      ProgramSetup made = usualSetup(dialect, stock, 20.0, settings.nose, above);
      made.tools = program->tools;
      return made;
    }();
    const auto path = runProgram(program->text, setup);
    QVERIFY(bool(path));
    ProgramSimulation simulation(bar, *path, setup);
    QVERIFY(simulation.run({}));
    QCOMPARE(simulation.collisionCount(), std::size_t{0});
    const TurnedProfile& part = simulation.part();
    for (std::size_t i = 0; i < part.size(); ++i) {
      const double z = part.z(i) - 100.0;
      if (z > kFaceSpacing) QVERIFY2(!part.hasMaterial(i), qPrintable(QString("z %1: %2").arg(z).arg(part.radius(i))));
      if (z < -kFaceSpacing && z > -29.0) QVERIFY(std::abs(part.radius(i) - 15.0) < 2e-3);
    }
  }

  // 5 mm off with a nose of 0.4 mm: 4.7 mm in passes of at most 0.6 mm are eight, and one takes the 0.3 mm that are
  // left. With a nose of 2 mm the depth of 1.5 mm decides: 4.7 / 1.5 are four, and one.
  void passesOfTheRoughingDepth() {
    CycleSettings settings;
    for (const auto& [nose, count] : {std::pair(0.4, std::size_t{8}), std::pair(2.0, std::size_t{4})}) {
      settings.nose = nose;
      const auto moves = faceCuts({5.0, 0.0}, 20.0, settings);
      QVERIFY(bool(moves));
      const std::vector<double> heights = facingHeights(*moves, 0.0);
      QCOMPARE(heights.size(), count + 1);
      double before = 5.0;
      for (const double height : heights) {
        QVERIFY(height < before && before - height <= std::min(1.5, 1.5 * nose) + 1e-9);
        before = height;
      }
      QVERIFY(std::abs(heights[count - 1] - 0.3) < 1e-9 && std::abs(heights.back()) < 1e-9);
      QVERIFY(moves->front().tool == settings.roughTool && moves->back().tool == settings.finishTool);
      // The centre of the nose goes to the axis, so that no pip is left.
      for (const ToolMove& move : *moves) QVERIFY(move.to.x() >= -nose - 1e-9);
    }
    // Less than the allowance is for the finishing tool alone.
    settings.nose = 0.4;
    QCOMPARE(facingHeights(*faceCuts({0.2, 0.0}, 20.0, settings), 0.0).size(), std::size_t{1});
    // To a hole, and no further than two noses into it.
    const auto beside = faceCuts({1.0, 6.0}, 20.0, settings);
    for (const ToolMove& move : *beside) QVERIFY(move.to.x() >= 6.0 - 2 * settings.nose - 1e-9);
    QVERIFY(!facingHeights(*beside, 6.0).empty());
  }

  // A part that ends at the face, by the bar or because it was faced before, is not faced again.
  void nothingToFace() {
    QVERIFY(faceCuts({0.0, 0.0}, 20.0, {}).value().empty());
    TurnedProfile bar({40.0, 101.0, 0.0}, kFaceSpacing);
    const EndStock whole = EndStock::of(bar, -100.0, 0.0);
    QVERIFY(std::abs(whole.height - 1.0) < 1e-9 && whole.hole == 0.0);
    QVERIFY(EndStock::of(bar, -101.0, 0.0).height < 1e-9);
    for (std::size_t i = 0; i < bar.size(); ++i)
      if (bar.z(i) > 100.0) bar.limitOuter(i, 0.0);
    QCOMPARE(EndStock::of(bar, -100.0, 0.0).height, 0.0);
    // A bar that has a hole of ⌀10 near its end only.
    TurnedProfile hollow({40.0, 101.0, 0.0}, kFaceSpacing);
    for (std::size_t i = 0; i < hollow.size(); ++i)
      if (hollow.z(i) > 80.0) hollow.limitInner(i, 5.0);
    QCOMPARE(EndStock::of(hollow, -100.0, 0.0).hole, 5.0);
    QCOMPARE(EndStock::of(hollow, -70.0, 0.0).hole, 0.0);
  }

  void extremes() {
    CycleSettings settings;
    settings.depth = 0.0;
    QVERIFY(!faceCuts({1.0, 0.0}, 20.0, settings));
    settings.depth = std::nan("");
    QVERIFY(!faceCuts({1.0, 0.0}, 20.0, settings));
    settings = {};
    settings.nose = 1e-9;
    QVERIFY(!faceCuts({1.0, 0.0}, 20.0, settings));
    QVERIFY(!faceCuts({std::numeric_limits<double>::infinity(), 0.0}, 20.0, {}));
    QVERIFY(faceCuts({std::nan(""), 0.0}, 20.0, {}).value().empty());
  }
};

HANDWHEEL_TEST(FaceCutsTest)
#include "FaceCutsTest.moc"
