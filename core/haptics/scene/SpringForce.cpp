// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/scene/SpringForce.h"

#include <cmath>

namespace handwheel {

namespace {

// Returns the torque, N·mm, of a spring (N·mm/rad) that turns one orientation to another by the shortest rotation.
Vec3 turningTorque(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to, double turning) {
  if (turning == 0.0) return Vec3::Zero();
  const Eigen::Quaterniond rotation = to * from.conjugate();
  const double sine = rotation.vec().norm();
  if (sine == 0.0) return Vec3::Zero();
  // A quaternion and its opposite are the same orientation; the smaller angle of the two is taken.
  const double angle = 2.0 * std::atan2(sine, std::abs(rotation.w()));
  return (turning * std::copysign(angle, rotation.w()) / sine) * rotation.vec();
}

}  // namespace

SpringForce::SpringForce(std::string id, std::vector<Spring> springs)
    : ForceSource(std::move(id)), m_springs(std::move(springs)) {
  for (const Spring& spring : m_springs) {
    m_bounds.stiffness += spring.stiffness;
    m_bounds.damping += spring.damping;
  }
}

ForceBounds SpringForce::advance(const TipState&, ForceOut&) noexcept {
  return m_bounds;
}

Vec3 SpringForce::force(const TipState& tip, double stiffness, double damping) noexcept {
  Vec3 sum = -damping * m_bounds.damping * tip.velocity;
  for (const Spring& spring : m_springs) sum += stiffness * spring.stiffness * (spring.target - tip.position);
  return sum;
}

Vec3 SpringForce::torque(const TipState& tip) noexcept {
  Vec3 sum = Vec3::Zero();
  for (const Spring& spring : m_springs) sum += turningTorque(tip.orientation, spring.turn, spring.turning);
  return sum;
}

}  // namespace handwheel
