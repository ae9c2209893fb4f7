// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/ComparisonIk.h"

#include <Eigen/QR>

namespace handwheel {

namespace {

constexpr std::uint32_t kMostComparisonSteps = 100;

using Numbers12 = Eigen::Matrix<double, 12, 1>;
using Derivative12 = Eigen::Matrix<double, 12, Eigen::Dynamic, 0, 12, kMostArmJoints>;

// step: computes the change of the joints from the Jacobian and the error, with lengths relative to the characteristic
// one, at a pose.
template <class Step>
NumericalIkResult iterated(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                           const NumericalIkSettings& settings, const Step& step) {
  NumericalIkResult result;
  result.values = start;
  result.starts = 1;
  if (!tip.matrix().allFinite()) return result;
  while (result.values.allFinite()) {
    ArmJacobian jacobian;
    const Pose at = arm.tipPose(result.values, jacobian);
    Eigen::Matrix<double, 6, 1> error = poseError(at, tip);
    result.distance = error.head<3>().norm();
    result.angle = error.tail<3>().norm();
    error.head<3>() /= settings.length;
    jacobian.topRows<3>() /= settings.length;
    result.isSolved = error.cwiseAbs().maxCoeff() <= settings.tolerance;
    if (result.isSolved || arm.size() == 0 || result.iterations == kMostComparisonSteps) break;
    result.values += step(jacobian, error, at);
    ++result.iterations;
  }
  return result;
}

}  // namespace

NumericalIkResult solvedByJacobian(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                   const NumericalIkSettings& settings) {
  const auto step = [](const ArmJacobian& jacobian, const Eigen::Matrix<double, 6, 1>& error, const Pose&) {
    return ArmValues(jacobian.completeOrthogonalDecomposition().solve(error));
  };
  return iterated(arm, tip, start, settings, step);
}

NumericalIkResult solvedByTaylor(const SerialArm& arm, const Pose& tip, const ArmValues& start,
                                 const NumericalIkSettings& settings) {
  const auto step = [&](const ArmJacobian& jacobian, const Eigen::Matrix<double, 6, 1>& error, const Pose& at) {
    Numbers12 missing;
    missing.head<3>() = error.head<3>();
    Derivative12 derivative(12, jacobian.cols());
    derivative.topRows<3>() = jacobian.topRows<3>();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const Vec3 column = at.linear().col(axis);
      missing.segment<3>(3 + 3 * axis) = tip.linear().col(axis) - column;
      for (Eigen::Index i = 0; i < jacobian.cols(); ++i)
        derivative.col(i).segment<3>(3 + 3 * axis) = Vec3(jacobian.col(i).tail<3>()).cross(column);
    }
    return ArmValues(derivative.completeOrthogonalDecomposition().solve(missing));
  };
  return iterated(arm, tip, start, settings, step);
}

}  // namespace handwheel
