// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/planners/Roadmap.h"

#include "../Scenes.h"
#include "TestClass.h"

#include <QtTest>
#include <thread>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A wall of balls between the two halves of the plane of an arm: the arm passes when it folds.
RobotScene sceneWithWall() {
  RobotScene scene = sceneOf(planarArm({250.0, 250.0, 200.0}, 10.0));
  std::uint32_t owner = 0;
  for (double x = 420.0; x < 900.0; x += 15.0) addBall(scene, {x, 0.0, 0.0}, 10.0, owner++);
  return scene;
}

ArmValues overTheWall(double more = 0.0) {
  return Eigen::Vector3d(0.9 + more, 0.4, 0.2);
}

PlanSettings withoutHurry() {
  PlanSettings settings;
  settings.seconds = 120.0;
  return settings;
}

}  // namespace

class RoadmapTest : public QObject {
  Q_OBJECT

 private slots:
  // The next plan uses the results of the first: nothing is checked again except the ends, in both directions.
  void theSecondPlanLooksAtNothing() {
    const RobotScene scene = sceneWithWall();
    Roadmap roadmap;
    const PlanResult first = roadmap.plan(scene, overTheWall(), -overTheWall(), withoutHurry());
    QVERIFY(first.outcome == PlanResult::Outcome::Solved);
    QVERIFY(leastAlong(scene, first.path, 2e-3) > 0.0);
    QVERIFY(roadmap.provenMotions() > 0);
    const std::size_t milestones = roadmap.milestones();
    const PlanResult again = roadmap.plan(scene, overTheWall(), -overTheWall(), withoutHurry());
    QVERIFY(again.path.front() == overTheWall() && again.path.back() == -overTheWall());
    const std::uint64_t ends = 2;
    QVERIFY(first.steps > 10 * ends);
    QCOMPARE(again.steps, ends);
    const PlanResult back = roadmap.plan(scene, -overTheWall(), overTheWall(), withoutHurry());
    QCOMPARE(back.steps, ends);
    QVERIFY(JointPath(back.path.rbegin(), back.path.rend()) == again.path);
    QCOMPARE(roadmap.milestones(), milestones);
  }

  // Other ends near by: fewer checks than for a new roadmap, and free as well.
  void otherEndsUseIt() {
    const RobotScene scene = sceneWithWall();
    Roadmap roadmap;
    roadmap.plan(scene, overTheWall(), -overTheWall(), withoutHurry());
    std::uint64_t kept = 0, anew = 0;
    for (const double more : {0.1, 0.2, -0.1, 0.3}) {
      Roadmap own;
      const PlanResult with = roadmap.plan(scene, overTheWall(more), -overTheWall(0.5 * more), withoutHurry());
      QVERIFY(with.outcome == PlanResult::Outcome::Solved);
      QVERIFY(leastAlong(scene, with.path, 2e-3) > 0.0);
      kept += with.steps;
      anew += own.plan(scene, overTheWall(more), -overTheWall(0.5 * more), withoutHurry()).steps;
    }
    QVERIFY2(2 * kept < anew, qPrintable(QString("%1 and %2").arg(kept).arg(anew)));
  }

  // Motions that were proven for one clearance tell nothing of a larger one.
  void anotherClearanceBeginsAnew() {
    const RobotScene scene = sceneWithWall();
    Roadmap roadmap;
    roadmap.plan(scene, overTheWall(), -overTheWall(), withoutHurry());
    PlanSettings wider = withoutHurry();
    wider.check.clearance = 15.0;
    const PlanResult result = roadmap.plan(scene, overTheWall(), -overTheWall(), wider);
    QVERIFY(result.outcome == PlanResult::Outcome::Solved);
    for (std::size_t i = 1; i < result.path.size(); ++i) {
      for (double share = 0.0; share <= 1.0; share += 1e-3) {
        const ArmValues at = result.path[i - 1] + share * (result.path[i] - result.path[i - 1]);
        QVERIFY(scene.nearestObstacle(at, 1e9).distance >= 15.0);
      }
    }
  }

  // For any number of different ends, the number of milestones stays within its limit.
  void itsMemoryIsBounded() {
    const RobotScene scene = sceneOf(planarArm({250.0, 250.0}, 10.0));
    Roadmap roadmap(40);
    for (int i = 0; i < 100; ++i) {
      const ArmValues start = Eigen::Vector2d(0.02 * i, 0.5), goal = Eigen::Vector2d(0.01 * i, 0.4);
      const PlanResult result = roadmap.plan(scene, start, goal, withoutHurry());
      QVERIFY(result.outcome == PlanResult::Outcome::Solved);
      QVERIFY(result.path.front() == start && result.path.back() == goal);
      QVERIFY(roadmap.milestones() <= 40);
    }
  }

  void severalThreads() {
    const RobotScene scene = sceneWithWall();
    Roadmap roadmap;
    std::vector<PlanResult> results(4);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < results.size(); ++i)
      threads.emplace_back([&, i] {
        const double more = 0.05 * static_cast<double>(i);
        results[i] = roadmap.plan(scene, overTheWall(more), -overTheWall(more), withoutHurry());
      });
    for (std::thread& thread : threads) thread.join();
    for (const PlanResult& each : results) QVERIFY(leastAlong(scene, each.path, 5e-3) > 0.0 && each.path.size() > 1);
  }
};

HANDWHEEL_TEST(RoadmapTest)
#include "RoadmapTest.moc"
