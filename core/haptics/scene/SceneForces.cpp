// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/scene/SceneForces.h"

#include <algorithm>
#include <utility>

namespace handwheel {

void SceneForces::follow(const ForceRenderer& previous) noexcept {
  const auto* other = dynamic_cast<const SceneForces*>(&previous);
  if (!other || !other->m_hasTicked) return;
  m_force.last = other->m_force.last;
  m_torque.last = other->m_torque.last;
  m_hasFollowed = true;
  for (const auto& source : m_sources) {
    if (const ForceSource* before = other->find(source->id())) source->follow(*before);
  }
}

void SceneForces::tick(const TipState& tip, ForceOut& out) noexcept {
  if (tip.isRestart) {
    m_hasFollowed = false;
    m_gapTime = 0.0;
  }
  m_hasTicked = true;
  ForceBounds all;
  double attractionStiffness = 0.0;
  for (const auto& source : m_sources) {
    const ForceBounds bounds = source->advance(tip, out);
    all.stiffness += bounds.stiffness;
    all.damping += bounds.damping;
    if (source->isAttraction()) attractionStiffness += bounds.stiffness;
  }

  // Damping of at most half of its limit leaves half of the stiffness limit for the springs.
  const double damping = std::min(all.damping, 0.5 * tip.dampingLimit);
  const double room = damping > 0.0 ? 1.0 - damping / tip.dampingLimit : 1.0;
  const double most = tip.stiffnessLimit * room;
  const double share = all.stiffness > most ? most / all.stiffness : 1.0;
  out.stiffness = share * all.stiffness;
  out.asked = all.stiffness;
  out.isSoftened = share < 1.0 || damping < all.damping;
  const double kept = all.damping > 0.0 ? damping / all.damping : 1.0;

  Vec3 attraction = Vec3::Zero(), resistance = Vec3::Zero(), turning = Vec3::Zero();
  for (const auto& source : m_sources) {
    (source->isAttraction() ? attraction : resistance) += source->force(tip, share, kept);
    (source->isAttraction() ? turning : out.torque) += source->torque(tip);
  }
  const bool isFirst = std::exchange(m_hasFollowed, false);
  if (isFirst) m_gapTime = kChangeOver;
  // The change of the force by the hand since the previous tick is no gap. It is at most the stiffness times the
  // distance moved, taken twice for a velocity that comes late. Else scenes that are exchanged often would let the
  // force lag.
  const double byHand = 2.0 * share * attractionStiffness * tip.velocity.norm() * tip.period;
  out.force = blended(m_force, attraction, isFirst, byHand) + resistance;
  out.torque += blended(m_torque, turning, isFirst, 0.0);
  m_gapTime = std::max(0.0, m_gapTime - tip.period);
}

Vec3 SceneForces::blended(Blend& blend, const Vec3& attraction, bool isFirst, double byHand) const {
  if (isFirst) {
    const Vec3 gap = blend.last - attraction;
    blend.gap = gap.norm() > byHand ? Vec3(gap * (1.0 - byHand / gap.norm())) : Vec3(Vec3::Zero());
  }
  blend.last = attraction + m_gapTime / kChangeOver * blend.gap;
  return blend.last;
}

const ForceSource* SceneForces::find(std::string_view id) const {
  const auto found = std::find_if(m_sources.begin(), m_sources.end(), [&](const auto& s) { return s->id() == id; });
  return found == m_sources.end() ? nullptr : found->get();
}

}  // namespace handwheel
