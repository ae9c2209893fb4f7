// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/LatheForce.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

LatheForce::LatheForce(std::shared_ptr<LatheChannel> channel, std::shared_ptr<const LatheMaterial> material,
                       const LatheTouch& touch, double base)
    : ForceSource(kLatheSource),
      m_channel(std::move(channel)),
      m_material(std::move(material)),
      m_touch(touch),
      m_base(base) {}

void LatheForce::follow(const ForceSource& previous) noexcept {
  const auto* other = dynamic_cast<const LatheForce*>(&previous);
  if (!other || other->m_channel != m_channel) return;
  m_contact = other->m_contact;
  m_outward = other->m_outward;
  m_wasFree = other->m_wasFree;
}

ForceBounds LatheForce::advance(const TipState& tip, ForceOut& out) noexcept {
  m_isHeld = m_isTouching = false;
  m_cut = {};
  m_press = {0.0, 0.0};
  if (!tip.position.allFinite()) return {};
  const std::uint32_t gesture = m_channel->inputs->gestureAt(tip);
  m_channel->inputs->push({tip, tip.position, gesture});
  m_patch = m_channel->patch.read();
  // The lathe measures the grip in its next step: until then no spring pulls.
  m_hold = tip.position;
  if (m_patch.gesture == gesture) m_hold = Vec3(m_patch.tip.x(), 0.0, m_patch.tip.y() + m_base) - m_patch.grip;
  m_isHeld = gesture != 0 && m_hold.allFinite();
  if (!m_isHeld) {
    touch(tip, out);
    return {m_touch.plane + (m_isTouching ? m_touch.stiffness : 0.0), 0.0};
  }
  m_wasFree = false;
  const CuttingForceModel* const law = m_material->lawOf(m_patch.tool);
  m_cut.cutting = m_patch.rub;
  m_press = m_patch.press;
  if (law && m_patch.cut.depth > 0.0) m_cut = worn(law->at(m_patch.cut), m_patch.wear);
  out.isContact = m_patch.cut.depth > 0.0 || !m_press.isZero(0.0);
  out.proxy = m_hold;
  return {std::max(m_touch.stiffness, m_touch.plane), steepestDamping(m_touch.feel)};
}

// Straight outward, by the depth of the finger in the half plane of the hand.
void LatheForce::touch(const TipState& tip, ForceOut& out) noexcept {
  const Vec3 across(tip.position.x(), tip.position.y(), 0.0);
  const double distance = across.norm();
  if (distance > 0.0) m_outward = across / distance;
  const ProfilePoint hand(distance, tip.position.z() - m_base);
  if (tip.isRestart || !std::exchange(m_wasFree, true)) m_contact.reset(hand);
  TurningTool finger;
  finger.noseRadius = LatheSimulation::kFinger;
  finger.stiffness = m_touch.stiffness;
  m_isTouching = m_contact.follow(m_patch.part, finger, hand, false, tip.period);
  if (!m_isTouching) return;
  m_surface = m_contact.tool().x() * m_outward + Vec3(0.0, 0.0, m_contact.tool().y() + m_base);
  out.isContact = true;
  out.proxy = m_surface;
}

// Rises to the middle of its reach and falls to its border, so that there is no step (He 2008, eq. 3-1).
double LatheForce::planeForce(double y) const noexcept {
  const double away = std::abs(y), reach = m_touch.planeReach;
  if (!(away < reach)) return 0.0;
  return std::copysign(m_touch.plane * std::min(away, reach - away), -y);
}

// An abrasive is pressed along the normal of the surface. The cutting force acts along the motion of the surface, which
// turns about +z at a positive speed: the tool is at +x. The other components act against the feed, and across it out
// of the material. The lips of a drill turn the work and do not push the tool aside.
Vec3 LatheForce::cutForce(double period) const noexcept {
  const ProfilePoint direction = m_patch.velocity.norm() > 0.0 ? m_patch.velocity.normalized() : ProfilePoint(0.0, 0.0);
  const ProfilePoint push = m_cut.radial * m_patch.passive - m_cut.feed * direction + m_press;
  const double aside = m_cut.isCouple ? 0.0 : std::copysign(m_cut.cutting, m_patch.spindleSpeed);
  Vec3 cut(push.x(), aside, push.y());
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
  if (m_isTouching) sum += stiffness * m_touch.stiffness * (m_surface - tip.position);
  if (!m_isHeld) return sum;
  const Vec3 spring = m_touch.stiffness * (m_hold - tip.position);
  sum += stiffness * Vec3(spring.x(), 0.0, spring.z());
  sum -= damping *
         Vec3(slideResistance(m_touch.feel, tip.velocity.x()), 0.0, slideResistance(m_touch.feel, tip.velocity.z()));
  if (m_cut == CutForces() && m_press.isZero(0.0)) return sum;
  const Vec3 cut = cutForce(tip.period);
  return cut.allFinite() ? Vec3(sum + cut) : sum;
}

}  // namespace handwheel
