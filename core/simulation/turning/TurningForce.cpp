// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/TurningForce.h"

#include <algorithm>

namespace handwheel {

TurningForce::TurningForce(std::shared_ptr<TurningChannel> channel, const TurningTool& tool, double base)
    : ForceSource(kTurningSource), m_channel(std::move(channel)), m_tool(tool), m_base(base) {}

void TurningForce::follow(const ForceSource& previous) noexcept {
  const auto* other = dynamic_cast<const TurningForce*>(&previous);
  if (!other || other->m_channel != m_channel) return;
  if (other->m_tool.side != m_tool.side) return;
  m_contact = other->m_contact;
  m_outward = other->m_outward;
  m_share = other->m_share;
  m_isPlaced = other->m_isPlaced;
}

ForceBounds TurningForce::advance(const TipState& tip, ForceOut& out) noexcept {
  const std::uint32_t gesture = m_channel->inputs->gestureAt(tip);
  const Vec3 across(tip.position.x(), tip.position.y(), 0.0);
  const double distance = across.norm();
  if (!std::isfinite(distance) || !std::isfinite(tip.position.z())) return {};
  if (distance > 0.0) m_outward = across / distance;
  const ProfilePoint hand(sideways(m_tool.side, distance), tip.position.z() - m_base);
  if (tip.isRestart || !m_isPlaced) m_contact.reset(hand);
  m_isPlaced = true;
  TurningTool carried = m_tool;
  carried.stiffness *= m_share;
  m_isTouching = m_contact.follow(m_channel->patch.read(), carried, hand, gesture != 0, tip.period);
  // In free space the proxy is the hand itself, as in recordings.
  m_proxy =
      m_isTouching
          ? Vec3(sideways(m_tool.side, m_contact.tool().x()) * m_outward + Vec3(0, 0, m_contact.tool().y() + m_base))
          : tip.position;
  m_channel->inputs->push({tip, m_proxy, gesture});
  if (!m_isTouching) return {};
  out.isContact = true;
  out.proxy = m_proxy;
  return {m_tool.stiffness, 0.0};
}

Vec3 TurningForce::force(const TipState& tip, double stiffness, double) noexcept {
  m_share = stiffness;
  if (!m_isTouching) return Vec3::Zero();
  return stiffness * m_tool.stiffness * (m_proxy - tip.position);
}

}  // namespace handwheel
