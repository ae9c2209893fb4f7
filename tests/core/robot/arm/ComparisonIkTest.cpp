// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/ComparisonIk.h"

#include "Arms.h"
#include "TestClass.h"

#include <Eigen/SVD>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr std::array kBothMethods = {&solvedByJacobian, &solvedByTaylor};

// Returns the least singular value of the Jacobian in metres and rad: 0 if the arm is singular.
double leastSingularValue(const SerialArm& arm, const ArmValues& values) {
  ArmJacobian jacobian;
  arm.tipPose(values, jacobian);
  jacobian.topRows<3>() /= 1000.0;
  return Eigen::JacobiSVD<Eigen::MatrixXd>(jacobian).singularValues()(5);
}

}  // namespace

// Tests the inverse kinematics that ours are compared with.
class ComparisonIkTest : public QObject {
  Q_OBJECT

 private slots:
  // From nearby, away from singularities, both reach a pose, and more exactly than to the 0.001 rad of the thesis.
  void reachNearPoses() {
    int compared = 0;
    QVERIFY(rc::check([&] {
      const auto robot = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(robotLibrary().size())));
      const SerialArm arm = *rc::gen::inRange(0, 4) == 0 ? anyArm(7) : libraryArm(robotLibrary()[robot].id);
      const ArmValues values = anyValuesOf(arm);
      if (leastSingularValue(arm, values) < 0.05) return;
      ArmValues start = values;
      for (double& each : start) each += evenlyBetween(-0.005, 0.005);
      const Pose tip = arm.tipPose(values);
      ++compared;
      for (const auto& solved : kBothMethods) {
        const NumericalIkResult found = solved(arm, tip, start, {.tolerance = 1e-9});
        RC_ASSERT(found.isSolved && found.iterations <= 20);
        RC_ASSERT(difference(arm.tipPose(found.values), tip, 1000.0) < 1e-8);
        RC_ASSERT(found.distance < 1e-5 && found.angle < 1e-8);
      }
    }));
    QVERIFY(compared > 20);
  }

  // A single revolute joint of 1 m: the first is exact at once along its circle; the second, whose numbers are sines
  // and cosines, steps by sin δ, as Newton's method for an angle by its coordinates does.
  void stepsOfARevoluteJoint() {
    const SerialArm arm = armOf(std::vector<DhRow>{{.a = 1000.0}});
    const double away = 0.3;
    const ArmValues start = ArmValues::Zero(1);
    const Pose tip = arm.tipPose(ArmValues::Constant(1, away));
    // (T')ᵀ (T* - T) / (T')ᵀ T': position (0, 1), columns of the rotation (0, 1) and (-1, 0): all give sin δ.
    const double second = std::sin(away), third = second + std::sin(away - second);
    const NumericalIkResult taylor = solvedByTaylor(arm, tip, start, {.tolerance = 1.01 * (away - third)});
    QCOMPARE(taylor.iterations, 2u);
    QVERIFY(std::abs(taylor.values[0] - third) < 1e-12);
    // J = (0, 1 | 1), δX = (cos δ - 1, sin δ | δ): the mean of sin δ and δ.
    const double mean = 0.5 * (std::sin(away) + away);
    const NumericalIkResult jacobian = solvedByJacobian(arm, tip, start, {.tolerance = 1.01 * (away - mean)});
    QCOMPARE(jacobian.iterations, 1u);
    QVERIFY(std::abs(jacobian.values[0] - mean) < 1e-12);
  }

  // Out of reach, from a singularity, with values that are not finite, or without joints: no hang, and nothing counts
  // as solved.
  void extremes() {
    const SerialArm arm = libraryArm("irb120");
    Pose far = Pose::Identity();
    far.translation() = Vec3(1e6, 0.0, 0.0);
    Pose broken = far;
    broken.translation().x() = std::nan("");
    for (const auto& solved : kBothMethods) {
      QVERIFY(!solved(arm, far, ArmValues::Zero(6), {}).isSolved);
      QVERIFY(!solved(arm, broken, ArmValues::Zero(6), {}).isSolved);
      QVERIFY(!solved(arm, far, ArmValues::Constant(6, std::nan("")), {}).isSolved);
      QVERIFY(solved(arm, arm.tipPose(ArmValues::Zero(6)), ArmValues::Zero(6), {}).isSolved);
      QVERIFY(solved(armOf({}), Pose::Identity(), ArmValues(), {}).isSolved);
      QVERIFY(!solved(armOf({}), far, ArmValues(), {}).isSolved);
    }
  }
};

HANDWHEEL_TEST(ComparisonIkTest)
#include "ComparisonIkTest.moc"
