// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/clay/ClayForce.h"

#include "machining/force/CuttingFeel.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

ClayForce::ClayForce(std::shared_ptr<ClayChannel> channel, const ClayFeel& feel)
    : ForceSource(kClaySource), m_channel(std::move(channel)), m_feel(feel) {}

void ClayForce::follow(const ForceSource& previous) noexcept {
  const auto* other = dynamic_cast<const ClayForce*>(&previous);
  if (!other || other->m_channel != m_channel) return;
  m_contact = other->m_contact;
  m_share = other->m_share;
  m_angle = other->m_angle;
  m_isPlaced = other->m_isPlaced;
}

ForceBounds ClayForce::advance(const TipState& tip, ForceOut& out) noexcept {
  const std::uint32_t gesture = m_channel->inputs->gestureAt(tip);
  m_isTouching = false;
  if (!tip.position.allFinite()) return {};
  if (tip.isRestart || !m_isPlaced) m_contact.place(tip.position);
  m_isPlaced = true;
  const ClayPatch& patch = m_channel->patch.read();
  if (patch.state) {
    ClayFeel feel = m_feel;
    feel.stiffness *= m_share;
    m_isTouching = m_contact.follow(patch.state->volume, feel, tip.position, gesture != 0, tip.period);
  } else {
    m_contact.place(tip.position);
  }
  m_isCutting = m_isTouching && m_feel.isCutting && gesture != 0;
  m_angle = std::fmod(m_angle + m_feel.spindle / 60.0 * 2.0 * M_PI * tip.period, 2.0 * M_PI);
  m_channel->inputs->push({tip, m_contact.tool(), gesture, false, pressureAt(tip)});
  if (!m_isTouching) return {};
  out.isContact = true;
  out.proxy = m_contact.tool();
  return {m_feel.stiffness, 0.0};
}

// By the spring between hand and tool. What nothing holds back has no pressure to go by.
double ClayForce::pressureAt(const TipState& tip) const noexcept {
  if (!m_isTouching) return 1.0;
  return std::min(1.0, m_share * m_feel.stiffness * (m_contact.tool() - tip.position).norm() / kFullForce);
}

// While it cuts the spring gives way by the vibration once a turn: so it is never stiffer than the loop can carry.
Vec3 ClayForce::force(const TipState& tip, double stiffness, double) noexcept {
  m_share = stiffness;
  if (!m_isTouching) return Vec3::Zero();
  const Vec3 spring = stiffness * m_feel.stiffness * (m_contact.tool() - tip.position);
  const double held = spring.norm();
  if (!m_isCutting || !(m_feel.spindle > 0.0) || !(held > 0.0)) return spring;
  const auto swing = [&](double angle) { return vibration({}, held, angle, m_feel.spindle, tip.period); };
  return (1.0 - 0.5 * (swing(0.5 * M_PI) - swing(m_angle)) / held) * spring;
}

}  // namespace handwheel
