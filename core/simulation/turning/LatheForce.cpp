// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/LatheForce.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

LatheForce::LatheForce(std::shared_ptr<LatheChannel> channel, std::shared_ptr<const LatheMaterial> material,
                       const LatheTouch& touch, double base)
    : ForceSource(kLatheSource),
      m_channel(std::move(channel)),
      m_material(std::move(material)),
      m_touch(touch),
      m_base(base) {}

ForceBounds LatheForce::advance(const TipState& tip, ForceOut& out) noexcept {
  m_isHeld = false;
  m_cut = {};
  if (!tip.position.allFinite()) return {};
  const std::uint32_t gesture = m_channel->inputs->gestureAt(tip);
  m_channel->inputs->push({tip, tip.position, gesture});
  m_patch = m_channel->patch.read();
  m_tool = Vec3(m_patch.tip.x(), 0.0, m_patch.tip.y() + m_base);
  m_isHeld = gesture != 0 && m_tool.allFinite();
  if (!m_isHeld) return {m_touch.plane, 0.0};
  const CuttingForceModel* const law = m_material->lawOf(m_patch.tool);
  m_cut = m_patch.pressed;
  if (law && m_patch.cut.depth > 0.0) m_cut = worn(law->at(m_patch.cut), m_patch.wear);
  out.isContact = m_patch.cut.depth > 0.0;
  out.proxy = m_tool;
  return {std::max(m_touch.stiffness, m_touch.plane), steepestDamping(m_touch.feel)};
}

// Rises to the middle of its reach and falls to its border, so that there is no step (He 2008, eq. 3-1).
double LatheForce::planeForce(double y) const noexcept {
  const double away = std::abs(y), reach = m_touch.planeReach;
  if (!(away < reach)) return 0.0;
  return std::copysign(m_touch.plane * std::min(away, reach - away), -y);
}

// Along the way of the surface, which turns about +z at a positive speed: the tool is at +x. Against the feed, and away
// from the axis.
Vec3 LatheForce::cutForce(double period) const noexcept {
  const ProfilePoint way = m_patch.velocity.norm() > 0.0 ? m_patch.velocity.normalized() : ProfilePoint(0.0, 0.0);
  Vec3 cut(m_cut.radial - m_cut.feed * way.x(), std::copysign(m_cut.cutting, m_patch.spindleSpeed),
           -m_cut.feed * way.y());
  cut *= m_touch.forceShare;
  if (const double norm = cut.norm(); norm > m_touch.mostForce) cut *= m_touch.mostForce / norm;
  cut.y() += std::copysign(
      vibration(m_touch.feel, std::abs(cut.y()), 2.0 * M_PI * m_patch.angle, std::abs(m_patch.spindleSpeed), period),
      cut.y());
  return cut;
}

Vec3 LatheForce::force(const TipState& tip, double stiffness, double damping) noexcept {
  if (!tip.position.allFinite()) return Vec3::Zero();
  Vec3 sum(0.0, stiffness * planeForce(tip.position.y()), 0.0);
  if (!m_isHeld) return sum;
  const Vec3 spring = m_touch.stiffness * (m_tool - tip.position);
  sum += stiffness * Vec3(spring.x(), 0.0, spring.z());
  sum -= damping *
         Vec3(slideResistance(m_touch.feel, tip.velocity.x()), 0.0, slideResistance(m_touch.feel, tip.velocity.z()));
  if (m_cut == CutForces()) return sum;
  const Vec3 cut = cutForce(tip.period);
  return cut.allFinite() ? Vec3(sum + cut) : sum;
}

}  // namespace handwheel
