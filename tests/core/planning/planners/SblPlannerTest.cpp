// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/planners/SblPlanner.h"

#include "../Scenes.h"
#include "TestClass.h"
#include "planning/PathShortcuts.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A wall of balls between the two halves of the plane of an arm, from this distance on: the arm passes when it folds.
RobotScene walledScene(const RobotModel& robot, double first) {
  RobotScene scene = sceneOf(robot);
  std::uint32_t owner = 0;
  for (double x = first; x < 900.0; x += 15.0) addBall(scene, {x, 0.0, 0.0}, 10.0, owner++);
  return scene;
}

PlanSettings patient() {
  PlanSettings settings;
  settings.seconds = 120.0;
  return settings;
}

}  // namespace

class SblPlannerTest : public QObject {
  Q_OBJECT

 private slots:
  // Past the wall from one side to the other: every point of the path is free, its ends are the requested ones, and
  // shortcuts keep that.
  void pastTheWall() {
    const RobotModel robot = planarArm({250.0, 250.0, 200.0}, 10.0);
    const RobotScene scene = walledScene(robot, 420.0);
    ArmValues start(3), goal(3);
    start << 0.9, 0.4, 0.2;
    goal << -0.9, -0.4, -0.2;
    const PlanResult result = planBySbl(scene, start, goal, patient());
    QVERIFY(result.outcome == PlanResult::Outcome::Solved);
    QVERIFY(result.path.front() == start && result.path.back() == goal);
    QVERIFY(leastAlong(scene, result.path, 2e-3) > 0.0);
    const JointPath shorter = shortened(scene, result.path, {}, 100, 60.0, 1);
    QVERIFY(shorter.front() == start && shorter.back() == goal);
    QVERIFY(lengthOf(scene, shorter) <= lengthOf(scene, result.path) + 1e-9);
    QVERIFY(leastAlong(scene, shorter, 2e-3) > 0.0);
    // The same seed gives the same path.
    const PlanResult again = planBySbl(scene, start, goal, patient());
    QVERIFY(again.path == result.path);
  }

  void clearanceIsKept() {
    const RobotModel robot = planarArm({250.0, 250.0, 200.0}, 10.0);
    const RobotScene scene = walledScene(robot, 480.0);
    ArmValues start(3), goal(3);
    start << 0.9, 0.4, 0.2;
    goal << -0.9, -0.4, -0.2;
    PlanSettings settings = patient();
    settings.check.clearance = 25.0;
    const PlanResult result = planBySbl(scene, start, goal, settings);
    QVERIFY(result.outcome == PlanResult::Outcome::Solved);
    QVERIFY(leastAlong(scene, result.path, 2e-3) >= 25.0);
  }

  void whyNot() {
    const RobotModel robot = planarArm({250.0, 250.0, 200.0}, 10.0);
    RobotScene scene = walledScene(robot, 420.0);
    ArmValues free(3), inTheWall = ArmValues::Zero(3), beyond = ArmValues::Constant(3, 3.5);
    free << 0.9, 0.4, 0.2;
    const PlanResult start = planBySbl(scene, inTheWall, free, patient());
    QVERIFY(start.outcome == PlanResult::Outcome::StartBlocked && start.blocked.owner != kNone);
    QVERIFY(planBySbl(scene, free, inTheWall, patient()).outcome == PlanResult::Outcome::GoalBlocked);
    QVERIFY(planBySbl(scene, free, beyond, patient()).outcome == PlanResult::Outcome::OutOfLimits);
    // If the wall begins at the base there is no path, and the planner ends nevertheless.
    const RobotScene closed = walledScene(robot, 100.0);
    ArmValues below(3);
    below << -0.3, -0.2, -0.1;
    PlanSettings few = patient();
    few.mostMilestones = 50;
    free << 0.3, 0.2, 0.1;
    QVERIFY(planBySbl(closed, free, below, few).path.empty());
  }

  // Links around joints that are 10 mm apart, which meet however these turn, though they are no neighbours.
  void alwaysMeeting() {
    RobotModel robot = planarArm({300.0, 10.0, 300.0}, 10.0);
    for (const char* name : {"link_2", "link_3"})
      robot.links[linkNamed(robot, name)].collisions.push_back({0, Pose::Identity(), {}});
    RobotScene scene = sceneOf(robot);
    const LinkPair pair{linkNamed(robot, "link_1"), linkNamed(robot, "link_3")};
    QVERIFY(scene.alwaysMeeting() == std::set<LinkPair>{pair});
    const ArmValues straight = ArmValues::Zero(3);
    QVERIFY(scene.nearest(straight, 1e9).distance <= 0.0);
    scene.allowPairs({pair});
    QVERIFY(scene.nearest(straight, 1e9).distance > 0.0);
  }
};

HANDWHEEL_TEST(SblPlannerTest)
#include "SblPlannerTest.moc"
