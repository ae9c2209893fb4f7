// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/scene/SpringForce.h"

namespace handwheel {

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

}  // namespace handwheel
