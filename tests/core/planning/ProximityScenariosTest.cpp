// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/ProximityScenarios.h"

#include "Scenes.h"
#include "TestClass.h"
#include "robot/Kinematics.h"

#include <QtTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kTolerance = 5.0, kBall = 5.0, kObstacle = 10.0;  // mm
const Vec3 kAt(0.0, 120.0, 0.0);

// Returns the distance of the balls of an arm from the obstacle, one by one.
double distanceByHand(const RobotModel& robot, const ArmValues& values) {
  const std::vector<Pose> poses = linkPoses(robot, JointValues(values));
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t l = 0; l < robot.links.size(); ++l)
    for (const auto& ball : robot.links[l].collisions)
      least = std::min(least, (poses[l] * ball.origin.translation() - kAt).norm() - kBall - kObstacle);
  return least;
}

}  // namespace

class ProximityScenariosTest : public QObject {
  Q_OBJECT

 private slots:
  // An arm of balls, and a ball beside it.
  void anArmAndABall() {
    const RobotModel robot = planarArm({100.0, 80.0}, kBall);
    RobotScene scene = sceneOf(robot);
    addBall(scene, kAt, kObstacle, 1);
    for (const auto wanted : {ProximityScenario::Apart, ProximityScenario::Near, ProximityScenario::Colliding}) {
      const auto values = valuesInScenario(scene, wanted, kTolerance);
      QVERIFY(values);
      const double exact = distanceByHand(robot, *values);
      QCOMPARE(scenarioOf(exact, kTolerance), wanted);
      const auto costs = measureProximity(scene, *values, kTolerance, 20);
      QVERIFY(costs && costs->scenario == wanted);
      QVERIFY(std::abs(costs->distance - exact) < 1e-9);
      QCOMPARE(costs->isNear, exact < kTolerance);
      QCOMPARE(costs->isColliding, exact <= 0.0);
      QCOMPARE(costs->contacts > 0, exact <= 0.0);
      for (const ProximityCost& cost : costs->queries) QVERIFY(cost.median > 0.0 && cost.slowest >= cost.median);
    }
  }

  // A measurement where the robot stands is at these very values; in a scenario, at those found for it.
  void measuredInAScenario() {
    const RobotModel robot = planarArm({100.0, 80.0}, kBall);
    RobotScene scene = sceneOf(robot);
    addBall(scene, kAt, kObstacle, 1);
    const ArmValues present = ArmValues::Zero(2);
    const ProximityRequest request{kTolerance, 5};
    const MeasuredScenario here = measuredScenario(scene, present, std::nullopt, request);
    QVERIFY(here.costs && *here.values == present);
    QVERIFY(std::abs(here.costs->distance - distanceByHand(robot, present)) < 1e-9);
    const MeasuredScenario near = measuredScenario(scene, present, ProximityScenario::Near, request);
    QVERIFY(near.costs && near.costs->scenario == ProximityScenario::Near && near.costs->isNear);
    const MeasuredScenario none = measuredScenario(sceneOf(robot), present, ProximityScenario::Colliding, request);
    QVERIFY(!none.values && !none.costs && none.wanted == ProximityScenario::Colliding);
  }

  // Without obstacles a robot is apart from everything, and gets nowhere else.
  void withoutObstacles() {
    const RobotScene scene = sceneOf(planarArm({100.0}, kBall));
    QVERIFY(valuesInScenario(scene, ProximityScenario::Apart, kTolerance));
    QVERIFY(!valuesInScenario(scene, ProximityScenario::Colliding, kTolerance));
    const auto costs = measureProximity(scene, ArmValues::Zero(1), kTolerance, 5);
    QVERIFY(costs && std::isinf(costs->distance) && !costs->isNear && !costs->isColliding && costs->contacts == 0);
  }

  void cancels() {
    const RobotScene scene = sceneOf(planarArm({100.0}, kBall));
    JobState state;
    state.cancelled = true;
    QVERIFY(!measureProximity(scene, ArmValues::Zero(1), kTolerance, 5, Progress(state)));
    QVERIFY(!valuesInScenario(scene, ProximityScenario::Apart, kTolerance, Progress(state)));
  }
};

HANDWHEEL_TEST(ProximityScenariosTest)
#include "ProximityScenariosTest.moc"
