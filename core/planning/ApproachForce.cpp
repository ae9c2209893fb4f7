// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/ApproachForce.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr double kLength = 1000.0;  // mm: divisor of lengths that makes them comparable to angles
constexpr double kDamping = 1e-6;   // relative to the squared singular values of the Jacobian, with lengths so divided

// Returns the force and the torque that a hand must apply at a point to balance these torques of the joints (N·mm, N),
// by the principle of virtual work.
Eigen::Matrix<double, 6, 1> handWrench(ArmJacobian jacobian, const ArmValues& torques) {
  jacobian.topRows<3>() /= kLength;
  Eigen::Matrix<double, 6, 6> square = jacobian * jacobian.transpose();
  square.diagonal().array() += kDamping;
  Eigen::Matrix<double, 6, 1> wrench = square.ldlt().solve(jacobian * torques);
  wrench.head<3>() /= kLength;
  return wrench;
}

}  // namespace

ApproachForce::ApproachForce(const RobotScene& scene, const SerialArm& arm, const Pose& tool,
                             const DistanceForceSettings& settings)
    : m_scene(scene), m_arm(arm), m_tool(tool), m_settings(settings), m_query(scene.approachQuery(m_joints)) {
  m_query.setTolerance(settings.tolerance);
}

ApproachForce::Felt ApproachForce::at(const ArmValues& values) {
  std::array<Pose, kMostArmJoints> poses;
  const std::span<Pose> placed(poses.data(), static_cast<std::size_t>(m_scene.size()));
  m_scene.jointPoses(values, placed);
  for (std::uint32_t body = 0; body < m_joints.size(); ++body) m_query.place(body, placed[m_joints[body]]);
  m_query.findNear(m_settings.reach, m_near);

  Felt felt;
  ArmValues torques = ArmValues::Zero(m_scene.size());
  for (const NearPair& near : m_near) {
    felt.distance = std::min(felt.distance, near.points.distance);
    const DistanceWrench wrench = distanceForce(std::span(&near, 1), Vec3::Zero(), m_settings);
    felt.energy += wrench.energy;
    for (std::uint32_t j = m_joints[near.bodies.first]; j != kNone; j = m_scene.parentOf(j)) {
      const Vec3 axis = placed[j].linear().col(2);
      torques[j] += m_scene.joint(j).isPrismatic
                        ? axis.dot(wrench.force)
                        : axis.dot(wrench.torque - placed[j].translation().cross(wrench.force));
    }
  }
  if (m_near.empty()) return felt;
  ArmJacobian jacobian;
  const Pose tip = m_arm.tipPose(values, jacobian);
  const Vec3 lever = tip.linear() * m_tool.translation();
  for (Eigen::Index j = 0; j < jacobian.cols(); ++j)
    jacobian.col(j).head<3>() += Vec3(jacobian.col(j).tail<3>()).cross(lever);
  Eigen::Matrix<double, 6, 1> wrench = handWrench(jacobian, torques);
  const double size = wrench.head<3>().norm();
  if (size > m_settings.largestForce) wrench *= m_settings.largestForce / size;
  felt.force = wrench.head<3>();
  felt.torque = wrench.tail<3>();
  return felt;
}

}  // namespace handwheel
