// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/Kinematics.h"

#include "Robots.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// The pose of a link as a product of exponentials (Brockett 1984): each joint's twist in the frame of the root, taken
// where all joints stand at 0, times its position. Matrix exponentials know nothing of axes and angles.
Eigen::Matrix4d productOfExponentials(const RobotModel& robot, const JointValues& values, std::uint32_t link) {
  std::vector<std::uint32_t> chain;
  for (std::uint32_t j = robot.links[link].parentJoint; j != kNone; j = robot.links[robot.joints[j].parent].parentJoint)
    chain.insert(chain.begin(), j);
  Eigen::Matrix4d home = Eigen::Matrix4d::Identity(), product = Eigen::Matrix4d::Identity();
  for (std::uint32_t j : chain) {
    const Joint& joint = robot.joints[j];
    home = home * joint.origin.matrix();
    if (joint.kind == JointKind::Fixed) continue;
    const Vec3 axis = home.topLeftCorner<3, 3>() * joint.axis, at = home.topRightCorner<3, 1>();
    Eigen::Matrix4d twist = Eigen::Matrix4d::Zero();
    if (joint.kind == JointKind::Prismatic) {
      twist.topRightCorner<3, 1>() = axis;
    } else {
      twist.topLeftCorner<3, 3>() << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
      twist.topRightCorner<3, 1>() = -axis.cross(at);
    }
    const double position = joint.dof == kNone ? joint.offset : joint.factor * values[joint.dof] + joint.offset;
    product = product * Eigen::Matrix4d((twist * position).exp());
  }
  return product * home;
}

}  // namespace

class KinematicsTest : public QObject {
  Q_OBJECT

 private slots:
  void planarArmInClosedForm();
  void slidesAlongItsAxis();
  void posesAreProductsOfExponentials();
  void posesAreRigid();
  void posesAreFinite();
  void jacobianIsTheDerivative();
  void jacobianOfWhatStandsStill();
};

void KinematicsTest::planarArmInClosedForm() {
  const RobotModel robot = readOrThrow(planarArm({0.4, 0.3, 0.2})).robot;
  const JointValues q = Eigen::Vector3d(0.3, -1.1, 2.0);
  const Pose tool = linkPoses(robot, q)[linkNamed(robot, "tool")];
  const double a = 0.3, b = a - 1.1, c = b + 2.0;
  const Vec3 expected(400 * std::cos(a) + 300 * std::cos(b) + 200 * std::cos(c),
                      400 * std::sin(a) + 300 * std::sin(b) + 200 * std::sin(c), 0);
  QVERIFY((tool.translation() - expected).norm() < 1e-10);
  QVERIFY((tool.linear() * Vec3::UnitX() - Vec3(std::cos(c), std::sin(c), 0)).norm() < 1e-14);
}

void KinematicsTest::slidesAlongItsAxis() {
  const RobotModel robot = readOrThrow(robotOf(link("a") + link("b") +
                                               joint("j", "prismatic", "a", "b",
                                                     "<origin xyz='0 1 0' rpy='0 0 1.5707963267948966'/>"
                                                     "<axis xyz='3 4 0'/>" +
                                                         limit(-1, 1))))
                               .robot;
  const Pose b = linkPoses(robot, JointValues::Constant(1, 100.0))[1];
  // 60 mm along the turned x (which is y), 80 mm along the turned y (which is -x).
  QVERIFY((b.translation() - Vec3(-80, 1060, 0)).norm() < 1e-9);
}

void KinematicsTest::posesAreProductsOfExponentials() {
  QVERIFY(rc::check("poses", [] {
    const RobotModel robot = readOrThrow(anyRobot()).robot;
    const JointValues q = anyValues(robot);
    const std::vector<Pose> poses = linkPoses(robot, q);
    for (std::uint32_t l = 0; l < robot.links.size(); ++l) {
      const Eigen::Matrix4d expected = productOfExponentials(robot, q, l);
      RC_ASSERT((poses[l].matrix() - expected).cwiseAbs().maxCoeff() < 1e-8);
    }
  }));
}

// After a long chain and at large values, too.
void KinematicsTest::posesAreRigid() {
  const RobotModel robot = readOrThrow(planarArm(std::vector<double>(200, 1.0))).robot;
  for (double angle : {0.0, 1e-9, 0.7, 1e6}) {
    const std::vector<Pose> poses = linkPoses(robot, JointValues::Constant(200, angle));
    QCOMPARE(poses.size(), std::size_t{202});  // the base, and the tool
    for (const Pose& pose : poses) {
      QVERIFY(pose.matrix().allFinite());
      QVERIFY((pose.linear() * pose.linear().transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
    }
  }
}

void KinematicsTest::posesAreFinite() {
  const std::string kFollows = limit(-1, 1) + "<mimic joint='j' multiplier='1e6' offset='-1e6'/>";
  for (const std::string& leader :
       {joint("j", "continuous", "a", "b"), joint("j", "revolute", "a", "b", "<limit lower='-inf' upper='inf'/>"),
        joint("j", "prismatic", "a", "b", limit(-1e300, 1e300))}) {
    const RobotModel robot =
        readOrThrow(robotOf(link("a") + link("b") + link("c") + leader + joint("k", "prismatic", "a", "c", kFollows)))
            .robot;
    for (double value : {0.0, 1e300, -1e308}) {
      const JointValues values = withinLimits(robot, JointValues::Constant(1, value));
      const std::vector<Pose> poses = linkPoses(robot, values);
      QCOMPARE(poses.size(), std::size_t{3});
      for (const Pose& pose : poses) QVERIFY(pose.matrix().allFinite());
    }
  }
}

void KinematicsTest::jacobianIsTheDerivative() {
  QVERIFY(rc::check("Jacobian", [] {
    const RobotModel robot = readOrThrow(anyRobot()).robot;
    const JointValues q = anyValues(robot);
    const auto l = *rc::gen::inRange<std::uint32_t>(0, std::uint32_t(robot.links.size()));
    const Vec3 inLink(anyNumber(-500, 500), anyNumber(-500, 500), anyNumber(-500, 500));
    const std::vector<Pose> poses = linkPoses(robot, q);
    const Jacobian found = jacobian(robot, poses, l, poses[l] * inLink);
    RC_ASSERT(found.cols() == q.size());
    for (Eigen::Index i = 0; i < q.size(); ++i) {
      constexpr double kStep = 1e-5;
      const JointValues step = JointValues::Unit(q.size(), i) * kStep;
      const Pose up = linkPoses(robot, q + step)[l], down = linkPoses(robot, q - step)[l];
      const Vec3 velocity = (up * inLink - down * inLink) / (2 * kStep);
      const Eigen::Matrix3d turning = (up.linear() - down.linear()) / (2 * kStep) * poses[l].linear().transpose();
      const Vec3 angular(turning(2, 1), turning(0, 2), turning(1, 0));
      // Factors of followers reach 1000 mm/rad and more; the differences leave a share of that.
      const double scale = 1.0 + found.col(i).norm() + std::pow(found.col(i).tail<3>().norm(), 3.0);
      RC_ASSERT((found.col(i).head<3>() - velocity).norm() < 1e-5 * scale);
      RC_ASSERT((found.col(i).tail<3>() - angular).norm() < 1e-5 * scale);
    }
  }));
}

void KinematicsTest::jacobianOfWhatStandsStill() {
  const RobotModel robot = readOrThrow(planarArm({0.4, 0.3})).robot;
  const std::vector<Pose> poses = linkPoses(robot, JointValues::Zero(2));
  QVERIFY(jacobian(robot, poses, robot.root, Vec3(1, 2, 3)).isZero(0.0));
  // A joint further out does not move a link before it.
  QVERIFY(jacobian(robot, poses, linkNamed(robot, "l1"), Vec3(1, 2, 3)).col(1).isZero(0.0));
}

HANDWHEEL_TEST(KinematicsTest)
#include "KinematicsTest.moc"
