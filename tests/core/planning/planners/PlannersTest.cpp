// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/planners/Planners.h"

#include "../Scenes.h"
#include "TestClass.h"
#include "planning/PathShortcuts.h"
#include "planning/RoutePlanning.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A wall of balls that an arm passes when it folds.
RobotScene walled(double first) {
  RobotScene scene = sceneOf(planarArm({250.0, 250.0, 200.0}, 10.0));
  std::uint32_t owner = 0;
  for (double x = first; x < 900.0; x += 15.0) addBall(scene, {x, 0.0, 0.0}, 10.0, owner++);
  return scene;
}

ArmValues above() {
  return Eigen::Vector3d(0.9, 0.4, 0.2);
}

PlanSettings longer() {
  PlanSettings settings;
  settings.seconds = 120.0;
  return settings;
}

}  // namespace

// Every planner keeps the common promises.
class PlannersTest : public QObject {
  Q_OBJECT

  static void eachPlanner() {
    QTest::addColumn<QByteArray>("id");
    for (const PlannerName& planner : planners()) QTest::newRow(planner.id) << QByteArray(planner.id);
  }

 private slots:
  void oursIsFirst() {
    QCOMPARE(QByteArray(planners().front().id), QByteArray("sbl"));
    std::set<std::string> ids;
    for (const PlannerName& each : planners()) ids.insert(each.id);
    QCOMPARE(ids.size(), planners().size());
  }

  // The path is free at very many points, with the clearance, and the ends are the requested ones, bit for bit.
  void pathsAreFree_data() { eachPlanner(); }
  void pathsAreFree() {
    QFETCH(QByteArray, id);
    const RobotScene scene = walled(480.0);
    PlanSettings settings = longer();
    settings.check.clearance = 10.0;
    const PlanResult result = planPath(scene, above(), -above(), settings, id.constData());
    QVERIFY(result.outcome == PlanResult::Outcome::Solved);
    QVERIFY(result.path.front() == above() && result.path.back() == -above());
    for (std::size_t i = 1; i < result.path.size(); ++i) {
      QVERIFY(scene.isWithinLimits(result.path[i]));
      const ArmValues difference = result.path[i] - result.path[i - 1];
      const int count = std::max(1, static_cast<int>(difference.cwiseAbs().maxCoeff() / 2e-3));
      for (int k = 0; k <= count; ++k) {
        const ArmValues at = result.path[i - 1] + difference * (static_cast<double>(k) / count);
        QVERIFY(scene.nearestObstacle(at, 1e9).distance >= 10.0);
        QVERIFY(scene.nearest(at, 1e9).distance > 0.0);
      }
    }
    QVERIFY(result.steps > 0 && result.milestones > 1);
  }

  // Over many queries the paths of our own planner are no longer than those of RRTConnect, after shortcuts.
  void lengths() {
    const RobotScene scene = walled(430.0);
    double sums[] = {0.0, 0.0};
    int queries = 0;
    for (int i = 0; i < 30; ++i) {
      const ArmValues start = Eigen::Vector3d(0.7 + 0.02 * i, 0.5 - 0.05 * i, 0.04 * i - 0.5);
      const ArmValues goal = Eigen::Vector3d(-0.6 - 0.025 * (30 - i), 0.6 - 0.03 * i, 0.3 - 0.03 * i);
      std::optional<double> found[2];
      for (const auto& [n, id] : {std::pair(0, "sbl"), std::pair(1, "rrtconnect")}) {
        const ArmValues ends[] = {start, goal};
        RouteSettings settings{.plan = longer(), .planner = id};
        settings.plan.seed = static_cast<std::uint64_t>(i) + 1;
        const Route route = planRoute(scene, ends, settings);
        if (route.isSolved()) found[n] = lengthOf(scene, route.legs.front());
      }
      if (!found[0] || !found[1]) continue;
      ++queries;
      sums[0] += *found[0];
      sums[1] += *found[1];
    }
    QVERIFY2(queries >= 20, qPrintable(QString::number(queries)));
    QVERIFY2(sums[0] <= 1.1 * sums[1], qPrintable(QString("%1 and %2 of %3").arg(sums[0]).arg(sums[1]).arg(queries)));
  }

  void theSeedRepeats_data() { eachPlanner(); }
  void theSeedRepeats() {
    QFETCH(QByteArray, id);
    if (id == "ompl-prm") return;  // looks for paths in a second thread
    const RobotScene scene = walled(420.0);
    const PlanResult first = planPath(scene, above(), -above(), longer(), id.constData());
    const PlanResult again = planPath(scene, above(), -above(), longer(), id.constData());
    QVERIFY(!first.path.empty());
    QVERIFY(first.path == again.path);
    QCOMPARE(first.steps, again.steps);
  }

  void whyNot_data() { eachPlanner(); }
  void whyNot() {
    QFETCH(QByteArray, id);
    const RobotScene scene = walled(420.0);
    const ArmValues inTheWall = ArmValues::Zero(3);
    const PlanResult start = planPath(scene, inTheWall, above(), longer(), id.constData());
    QVERIFY(start.outcome == PlanResult::Outcome::StartBlocked && start.blocked.owner != kNone);
    QVERIFY(planPath(scene, above(), inTheWall, longer(), id.constData()).outcome == PlanResult::Outcome::GoalBlocked);
    QVERIFY(planPath(scene, above(), ArmValues::Constant(3, 3.5), longer(), id.constData()).outcome ==
            PlanResult::Outcome::OutOfLimits);
    QVERIFY(planPath(scene, above(), above(), longer(), id.constData()).outcome == PlanResult::Outcome::Solved);
  }

  // Without a path each planner ends after its time, and at once if it is cancelled.
  void eachEnds_data() { eachPlanner(); }
  void eachEnds() {
    QFETCH(QByteArray, id);
    const RobotScene scene = walled(100.0);
    const ArmValues start = Eigen::Vector3d(0.3, 0.2, 0.1);
    PlanSettings settings;
    settings.seconds = 0.05;
    settings.mostMilestones = 50;
    QVERIFY(planPath(scene, start, -start, settings, id.constData()).outcome == PlanResult::Outcome::TimeOut);
    JobState state;
    state.cancelled = true;
    QVERIFY(planPath(scene, start, -start, longer(), id.constData(), Progress(state)).outcome ==
            PlanResult::Outcome::Cancelled);
  }
};

HANDWHEEL_TEST(PlannersTest)
#include "PlannersTest.moc"
