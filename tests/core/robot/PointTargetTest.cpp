// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/PointTarget.h"

#include "robot/Kinematics.h"

#include "Robots.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace handwheel;
using namespace handwheel::test;

namespace {

PointTarget toolPull(const RobotModel& robot, const Vec3& target) {
  return {linkNamed(robot, "tool"), Vec3::Zero(), target};
}

bool isWithinLimits(const RobotModel& robot, const JointValues& values) {
  for (std::size_t i = 0; i < robot.dofs.size(); ++i) {
    const JointLimits& limits = robot.jointOfDof(i).limits;
    const double v = values[Eigen::Index(i)];
    if (!(v >= limits.lower && v <= limits.upper)) return false;
  }
  return true;
}

}  // namespace

class PointTargetTest : public QObject {
  Q_OBJECT

 private slots:
  void elbowAngleOfTwoLinks();
  void outOfReachStretches();
  void atTheLimit();
  void throughALimit();
  void slidesAndTurns();
  void oneJointOnly();
  void singularPoses();
  void nothingToMove();
  void neverFurtherNeverOutside();
  void extremes();
};

// The law of cosines.
void PointTargetTest::elbowAngleOfTwoLinks() {
  const RobotModel robot = readOrThrow(planarArm({0.4, 0.3})).robot;
  const PointTarget pull = toolPull(robot, Vec3(250, 350, 0));
  const JointValues q = pulled(robot, Eigen::Vector2d(0.2, 0.9), pull);
  QVERIFY(targetDistance(robot, q, pull) < 1e-5);
  const double r2 = 250.0 * 250 + 350.0 * 350;
  const double elbow = std::acos((r2 - 400.0 * 400 - 300.0 * 300) / (2.0 * 400 * 300));
  QVERIFY(std::abs(q[1] - elbow) < 1e-6);  // the side on which it began
}

void PointTargetTest::outOfReachStretches() {
  const RobotModel robot = readOrThrow(planarArm({0.4, 0.3})).robot;
  const PointTarget pull = toolPull(robot, Vec3(3000, 4000, 0));
  const JointValues q = pulled(robot, Eigen::Vector2d(0.2, 0.9), pull, 200);
  QVERIFY(std::abs(targetDistance(robot, q, pull) - 4300.0) < 1e-2);
  QVERIFY(std::abs(q[0] - std::atan2(4.0, 3.0)) < 1e-2);
  // For a target far away, only the direction counts.
  const PointTarget far = toolPull(robot, Vec3(3e9, 4e9, 0));
  const JointValues same = pulled(robot, Eigen::Vector2d(0.2, 0.9), far, 200);
  QVERIFY(std::abs(same[0] + 0.5 * same[1] - std::atan2(4.0, 3.0)) < 0.1);
}

void PointTargetTest::atTheLimit() {
  const RobotModel robot = readOrThrow(planarArm({0.4}, limit(-0.5, 0.5))).robot;
  const JointValues q = pulled(robot, JointValues::Zero(1), toolPull(robot, Vec3(0, 400, 0)));
  QCOMPARE(q[0], 0.5);
}

// The first joint cannot help any more; the second reaches the target alone.
void PointTargetTest::throughALimit() {
  const RobotModel robot = readOrThrow(planarArm({0.4, 0.3}, limit(-1.0, 1.0))).robot;
  const Vec3 elbow(400 * std::cos(1.0), 400 * std::sin(1.0), 0);
  const Vec3 target = elbow + 300 * Vec3(std::cos(1.8), std::sin(1.8), 0);
  const PointTarget pull = toolPull(robot, target);
  const JointValues q = pulled(robot, Eigen::Vector2d(0.9, 0.0), pull, 200);
  QVERIFY(isWithinLimits(robot, q));
  QVERIFY(targetDistance(robot, q, pull) < 1e-3);
}

void PointTargetTest::slidesAndTurns() {
  const RobotModel robot =
      readOrThrow(robotOf(link("a") + link("b") + link("tool") +
                          joint("turn", "continuous", "a", "b", "<axis xyz='0 0 1'/>") +
                          joint("slide", "prismatic", "b", "tool", "<axis xyz='1 0 0'/>" + limit(0.1, 1))))
          .robot;
  const PointTarget pull = toolPull(robot, Vec3(-300, 400, 0));
  const JointValues q = pulled(robot, Eigen::Vector2d(1.0, 200.0), pull);
  QVERIFY(targetDistance(robot, q, pull) < 1e-5);
  QVERIFY(std::abs(q[0] - std::atan2(4.0, -3.0)) < 1e-7);
  QVERIFY(std::abs(q[1] - 500.0) < 1e-4);
}

void PointTargetTest::oneJointOnly() {
  const RobotModel robot = readOrThrow(planarArm({0.4, 0.3})).robot;
  PointTarget pull = toolPull(robot, Vec3(400, 300, 0));
  pull.dof = 1;
  const JointValues q = pulled(robot, Eigen::Vector2d(0.0, 0.3), pull);
  QCOMPARE(q[0], 0.0);
  QVERIFY(std::abs(q[1] - std::numbers::pi / 2) < 1e-6);
}

void PointTargetTest::singularPoses() {
  const RobotModel robot = readOrThrow(planarArm({0.4, 0.3})).robot;
  // Stretched: pulled straight out or in, no joint moves the point in that direction; sideways works.
  const JointValues stretched = JointValues::Zero(2);
  for (const Vec3& target : {Vec3(900, 0, 0), Vec3(500, 0, 0), Vec3(700, 0, 0), Vec3(700, 0, 50)})
    QVERIFY(pulled(robot, stretched, toolPull(robot, target)).allFinite());
  const PointTarget aside = toolPull(robot, Vec3(600, 200, 0));
  QVERIFY(targetDistance(robot, pulled(robot, stretched, aside), aside) < 1e-3);
  // Folded onto the first axis: the first joint has no lever.
  const RobotModel even = readOrThrow(planarArm({0.3, 0.3})).robot;
  const PointTarget out = toolPull(even, Vec3(0, 200, 0));
  QVERIFY(targetDistance(even, pulled(even, Eigen::Vector2d(0.0, std::numbers::pi), out), out) < 1e-3);
}

void PointTargetTest::nothingToMove() {
  const RobotModel robot = readOrThrow(planarArm({0.4})).robot;
  const PointTarget atRoot{robot.root, Vec3(1, 2, 3), Vec3(100, 0, 0)};
  QCOMPARE(pulled(robot, JointValues::Zero(1), atRoot), JointValues(JointValues::Zero(1)));
  const RobotModel stiff = readOrThrow(robotOf(link("tool"))).robot;
  QCOMPARE(pulled(stiff, JointValues(0), toolPull(stiff, Vec3(1, 0, 0))).size(), Eigen::Index{0});
}

void PointTargetTest::neverFurtherNeverOutside() {
  QVERIFY(rc::check("pulled", [] {
    const RobotModel robot = readOrThrow(anyRobot()).robot;
    const JointValues q = withinLimits(robot, anyValues(robot, 2.5));
    const PointTarget pull{*rc::gen::inRange<std::uint32_t>(0, std::uint32_t(robot.links.size())),
                           Vec3(anyNumber(-100, 100), anyNumber(-100, 100), anyNumber(-100, 100)),
                           Vec3(anyNumber(-4000, 4000), anyNumber(-4000, 4000), anyNumber(-4000, 4000))};
    const JointValues after = pulled(robot, q, pull);
    RC_ASSERT(after.allFinite());
    RC_ASSERT(targetDistance(robot, after, pull) <= targetDistance(robot, q, pull) + 1e-6);
    RC_ASSERT(isWithinLimits(robot, after));
  }));
}

void PointTargetTest::extremes() {
  for (double size : {1e-6, 1e-3, 1.0, 1e3, 1e5}) {
    const RobotModel robot = readOrThrow(planarArm({0.4 * size, 0.3 * size})).robot;
    const PointTarget pull = toolPull(robot, size * Vec3(250, 350, 0));
    QVERIFY(targetDistance(robot, pulled(robot, Eigen::Vector2d(0.2, 0.9), pull), pull) < 1e-5 * size);
    for (double far : {1e12, 1e150, 1e308}) {
      QVERIFY(pulled(robot, Eigen::Vector2d(0.2, 0.9), toolPull(robot, Vec3(far, -far, far))).allFinite());
    }
  }
}

HANDWHEEL_TEST(PointTargetTest)
#include "PointTargetTest.moc"
