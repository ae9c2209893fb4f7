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
  m_give = other->m_give;
  m_isPlaced = other->m_isPlaced && other->m_feel.reach == m_feel.reach;  // else another point of the tool is felt
}

ForceBounds ClayForce::advance(const TipState& tip, ForceOut& out) noexcept {
  const std::uint32_t gesture = m_channel->inputs->gestureAt(tip);
  m_hand = tip.position - m_feel.reach * (tip.orientation * Vec3::UnitZ());
  if (!m_hand.allFinite()) {
    m_isTouching = m_isCutting = false;
    return {};
  }
  if (tip.isRestart || !m_isPlaced) m_contact.reset(m_hand);
  m_isPlaced = true;
  swing(tip.period);
  const ClayPatch& patch = m_channel->patch.read();
  m_isTouching = false;
  if (patch.state) {
    ClayFeel feel = m_feel;
    feel.stiffness *= m_share * m_give;
    m_isTouching = m_contact.follow(patch.state->volume, feel, m_hand, gesture != 0, tip.period,
                                    patch.load ? &*patch.load : nullptr);
  } else {
    m_contact.reset(m_hand);
  }
  m_isCutting = m_isTouching && m_feel.isCutting && gesture != 0;
  const Vec3 tool = tip.position + m_contact.tool() - m_hand;
  // Without contact no pressure can be derived from the force.
  const double pressure = m_isTouching ? std::min(1.0, held() / kFullForce) : 1.0;
  m_channel->inputs->push({tip, tool, gesture, false, pressure});
  if (!m_isTouching) return {};
  out.isContact = true;
  out.proxy = tool;
  if (m_isCutting && patch.load) out.torque += held() * patch.load->torque;
  return {m_feel.stiffness, 0.0};
}

// While it cuts, the vibration once a turn softens the spring, which so is never stiffer than the loop can carry. The
// tool moves with the speed of the reduced force, so the mean of the force stays.
void ClayForce::swing(double period) noexcept {
  m_angle = std::fmod(m_angle + m_feel.spindle / 60.0 * 2.0 * M_PI * period, 2.0 * M_PI);
  m_give = 1.0;
  const double spring = m_share * m_feel.stiffness * (m_contact.tool() - m_hand).norm();
  if (!m_isCutting || !(m_feel.spindle > 0.0) || !(spring > 0.0)) return;
  const auto at = [&](double angle) { return vibration({}, spring, angle, m_feel.spindle, period); };
  m_give = 1.0 - 0.5 * (at(0.5 * M_PI) - at(m_angle)) / spring;
}

// N, of the spring between hand and tool.
double ClayForce::held() const noexcept {
  return m_share * m_give * m_feel.stiffness * (m_contact.tool() - m_hand).norm();
}

Vec3 ClayForce::force(const TipState&, double stiffness, double) noexcept {
  m_share = stiffness;
  if (!m_isTouching) return Vec3::Zero();
  return m_share * m_give * m_feel.stiffness * (m_contact.tool() - m_hand);
}

}  // namespace handwheel
