// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/HeldForce.h"

#include <algorithm>

namespace handwheel {

HeldForce::HeldForce(ProximityQuery query, std::uint32_t held, const DistanceForceSettings& settings)
    : m_query(std::move(query)), m_held(held), m_settings(settings) {
  m_query.setTolerance(settings.tolerance);
}

void HeldForce::leaveOutTouching() {
  constexpr double kNearlyTouching = 1e-9;  // mm
  for (std::uint32_t body = 0; body < m_held; ++body) m_query.place(body, Pose::Identity());
  m_query.findNear(kNearlyTouching, m_near);
  for (const NearPair& near : m_near) m_leftOut.push_back(near.bodies);
}

HeldForce::Felt HeldForce::at(const Pose& displacement, const Vec3& reference) {
  Felt felt;
  if (!displacement.matrix().allFinite() || !reference.allFinite()) return felt;
  for (std::uint32_t body = 0; body < m_held; ++body) m_query.place(body, displacement);
  m_query.findNear(m_settings.reach, m_near);
  std::erase_if(m_near,
                [this](const NearPair& near) { return std::ranges::find(m_leftOut, near.bodies) != m_leftOut.end(); });
  for (const NearPair& near : m_near) felt.distance = std::min(felt.distance, near.points.distance);
  felt.wrench = distanceForce(m_near, reference, m_settings);
  return felt;
}

}  // namespace handwheel
