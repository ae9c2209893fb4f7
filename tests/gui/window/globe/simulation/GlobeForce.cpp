// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/simulation/GlobeForce.h"

namespace handwheel::test {

std::optional<double> GlobePatch::heightTowards(const Vec3& p) const {
  const Vec3 direction = p.stableNormalized();
  if (count == 0 || (direction - centre).norm() > kChord - kGlobeReach) return std::nullopt;
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = globeWeight((globeDirections()[numbers[i]] - direction).norm());
    sum += weight * dents[i];
    weights += weight;
  }
  return weights > 0.0 ? radius * (1.0 - sum / weights) : radius;
}

GlobePatch patchAround(const GlobeSurface& surface, const Vec3& p) {
  GlobePatch patch;
  patch.centre = p.stableNormalized();
  patch.radius = surface.radius();
  for (std::uint32_t i = 0; i < kGlobePoints && patch.count < GlobePatch::kMost; ++i) {
    if ((globeDirections()[i] - patch.centre).norm() > GlobePatch::kChord) continue;
    patch.numbers[patch.count] = i;
    patch.dents[patch.count++] = surface.dent(i);
  }
  return patch;
}

GlobeForce::GlobeForce(GlobeSurface surface, const Pose& pose, double stiffness, std::shared_ptr<DentChannel> channel)
    : ForceSource(kGlobeSource),
      m_surface(std::move(surface)),
      m_pose(pose),
      m_stiffness(stiffness),
      m_channel(std::move(channel)) {}

ForceBounds GlobeForce::advance(const TipState& tip, ForceOut& out) noexcept {
  m_isTouching = false;
  const Vec3 inside = m_pose.inverse() * tip.position;
  const double distance = inside.norm();
  if (!std::isfinite(distance)) return {};
  std::optional<double> height;
  if (m_channel) height = m_channel->patch.read().heightTowards(inside);
  if (!height) height = m_surface.heightTowards(inside);
  m_isTouching = distance > 0.0 && distance < *height;
  m_proxy = m_isTouching ? Vec3(m_pose * Vec3(*height / distance * inside)) : tip.position;
  if (m_channel) m_channel->inputs->push({tip, m_proxy, m_channel->inputs->gestureAt(tip)});
  if (!m_isTouching) return {};
  out.isContact = true;
  out.proxy = m_proxy;
  return {m_stiffness, 0.0};
}

Vec3 GlobeForce::force(const TipState& tip, double stiffness, double) noexcept {
  if (!m_isTouching) return Vec3::Zero();
  return stiffness * m_stiffness * (m_proxy - tip.position);
}

}  // namespace handwheel::test
