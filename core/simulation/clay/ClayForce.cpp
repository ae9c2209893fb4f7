// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/clay/ClayForce.h"

namespace handwheel {

ClayForce::ClayForce(std::shared_ptr<ClayChannel> channel, const ClayFeel& feel)
    : ForceSource(kClaySource), m_channel(std::move(channel)), m_feel(feel) {}

void ClayForce::follow(const ForceSource& previous) noexcept {
  const auto* other = dynamic_cast<const ClayForce*>(&previous);
  if (!other || other->m_channel != m_channel) return;
  m_contact = other->m_contact;
  m_share = other->m_share;
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
  m_channel->inputs->push({tip, m_contact.tool(), gesture});
  if (!m_isTouching) return {};
  out.isContact = true;
  out.proxy = m_contact.tool();
  return {m_feel.stiffness, 0.0};
}

Vec3 ClayForce::force(const TipState& tip, double stiffness, double) noexcept {
  m_share = stiffness;
  if (!m_isTouching) return Vec3::Zero();
  return stiffness * m_feel.stiffness * (m_contact.tool() - tip.position);
}

}  // namespace handwheel
