// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/PointTarget.h"

#include "base/Tolerance.h"
#include "robot/Kinematics.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kLongestPullTurn = 0.3;    // rad per step: the Jacobian is valid only nearby
constexpr double kLeastPullDamping = 1e-9;  // relative to (lengths / reach)²
constexpr double kPullErrorDamping = 2e-3;  // additional damping, for each (error / reach)²
constexpr double kStrongerDamping = 16.0;   // factor after a step that led away
constexpr int kStalls = 6;                  // number of successive steps that led away, after which the search ends

// One step along the degrees of freedom that are still free. Lengths are divided by the reach, so that turning by a
// radian and sliding by the reach have the same weight.
class Step {
 public:
  Step(const RobotModel& robot, const JointValues& values, const PointTarget& pull, double reach)
      : m_robot(robot), m_values(values) {
    const std::vector<Pose> poses = linkPoses(robot, values);
    const Vec3 point = poses[pull.link] * pull.point;
    m_distance = (pull.target - point).norm();
    m_error = (pull.target - point) / std::max(m_distance, reach);
    m_columns = jacobian(robot, poses, pull.link, point).topRows<3>() / reach;
    m_units = Eigen::VectorXd::Ones(values.size());
    for (Eigen::Index dof = 0; dof < values.size(); ++dof) {
      if (robot.jointOfDof(static_cast<std::size_t>(dof)).kind == JointKind::Prismatic) m_units[dof] = reach;
      if (pull.dof != kNone && dof != pull.dof) m_columns.col(dof).setZero();
    }
    m_columns *= m_units.asDiagonal();
  }

  double distance() const { return m_distance; }  // mm

  // Solves (JᵀJ + λI) δ = Jᵀe, or equivalently δ = Jᵀ(JJᵀ + λI)⁻¹e; joints that meet a limit are set to it, and the
  // others solved again for the remaining error.
  JointValues taken(double damping) const {
    Eigen::Matrix3Xd columns = m_columns;
    Vec3 error = m_error;
    JointValues values = m_values;
    const double lambda = damping * (kLeastPullDamping + kPullErrorDamping * m_error.squaredNorm());
    for (Eigen::Index round = 0; round <= values.size(); ++round) {
      Eigen::Matrix3d square = columns * columns.transpose();
      square.diagonal().array() += lambda;
      Eigen::VectorXd delta = columns.transpose() * square.ldlt().solve(error);
      const double longest = delta.size() == 0 ? 0.0 : delta.cwiseAbs().maxCoeff();
      if (!std::isfinite(longest)) return m_values;
      if (longest > kLongestPullTurn) delta *= kLongestPullTurn / longest;
      const JointValues wanted = values + m_units.cwiseProduct(delta);
      if (!stopAtLimits(wanted, values, columns, error)) return wanted;
    }
    return values;
  }

 private:
  bool stopAtLimits(const JointValues& wanted, JointValues& values, Eigen::Matrix3Xd& columns, Vec3& error) const {
    bool stopped = false;
    for (Eigen::Index dof = 0; dof < wanted.size(); ++dof) {
      const Joint& joint = m_robot.jointOfDof(static_cast<std::size_t>(dof));
      if (joint.kind == JointKind::Continuous || columns.col(dof).isZero(0.0)) continue;
      const double kept = joint.nearest(wanted[dof]);
      if (kept == wanted[dof]) continue;
      error -= columns.col(dof) * ((kept - values[dof]) / m_units[dof]);
      values[dof] = kept;
      columns.col(dof).setZero();
      stopped = true;
    }
    return stopped;
  }

  const RobotModel& m_robot;
  const JointValues& m_values;
  double m_distance;
  Vec3 m_error;                // relative to the reach; larger errors pull no harder
  Eigen::Matrix3Xd m_columns;  // relative to the reach, per radian or reach
  Eigen::VectorXd m_units;     // units of the degrees of freedom
};

// Returns the length of the chain that moves the point, with slides at their useful length; never 0.
double reachOf(const RobotModel& robot, const PointTarget& pull, double distance) {
  double reach = pull.point.norm();
  for (std::uint32_t j = robot.links[pull.link].parentJoint; j != kNone;
       j = robot.links[robot.joints[j].parent].parentJoint) {
    const Joint& joint = robot.joints[j];
    reach += joint.origin.translation().norm();
    if (joint.kind == JointKind::Prismatic) reach += std::min(joint.limits.upper - joint.limits.lower, distance);
  }
  return std::max(reach, 1e-6);
}

}  // namespace

double targetDistance(const RobotModel& robot, const JointValues& values, const PointTarget& pull) {
  return (linkPoses(robot, values)[pull.link] * pull.point - pull.target).norm();
}

JointValues pulled(const RobotModel& robot, const JointValues& values, const PointTarget& pull, int steps) {
  assert(values.allFinite() && pull.target.allFinite() && pull.point.allFinite());
  JointValues best = withinLimits(robot, values);
  const double reach = reachOf(robot, pull, targetDistance(robot, best, pull));
  double damping = 1.0;
  int stalls = 0;
  for (int i = 0; i < steps && stalls < kStalls; ++i) {
    const Step step(robot, best, pull, reach);
    if (step.distance() < tolerance::kReached * reach) break;
    const JointValues next = step.taken(damping);
    if (targetDistance(robot, next, pull) < step.distance()) {
      best = next;
      damping = std::max(1.0, damping / kStrongerDamping);
      stalls = 0;
    } else {
      damping *= kStrongerDamping;
      ++stalls;
    }
  }
  return withinLimits(robot, best);
}

}  // namespace handwheel
