// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/scene/SceneForces.h"

#include <algorithm>
#include <utility>

namespace handwheel {

SceneForces::SceneForces(SceneHaptics feel)
    : m_feel(std::move(feel)), m_snapSum(m_feel.snap ? m_feel.snap->most : SnapSum::kMost) {}

void SceneForces::follow(const ForceSource& previous) noexcept {
  const auto* other = dynamic_cast<const SceneForces*>(&previous);
  if (!other || !other->m_isPlaced) return;
  m_snapProxy = other->m_snapProxy;
  m_pulled = other->m_pulled;
  m_hasFollowed = true;
  // In front of another surface the proxy begins at the tip.
  const auto &mine = m_feel.surface, &theirs = other->m_feel.surface;
  if (!mine || !theirs || !mine->surface.isVersionOf(theirs->surface)) return;
  m_god = other->m_god;
  m_isPlaced = true;
  m_god.surfaceChanged(mine->surface);
}

void SceneForces::tick(const TipState& tip, ForceOut& out) noexcept {
  if (tip.isRestart) {
    m_snapProxy.release();
    m_hasFollowed = false;
    m_gapTime = 0.0;
  }
  if (tip.isRestart || !m_isPlaced) m_god.place(entryOf(tip.position));
  m_isPlaced = true;
  touch(tip);
  snap(tip);
  const Contact& contact = m_god.contact();
  out.isContact = m_feel.surface && contact.touching;
  if (out.isContact) {
    out.proxy = contact.proxy;
  } else if (m_feel.snap) {
    out.proxy = m_pull.proxy;
  }
  if (m_feel.snap && m_feel.snap->method == SnapMethod::Proxy) {
    out.isHeld = isHeldBy(SnapKind::Point) || isHeldBy(SnapKind::Segment);
    out.held = m_pull.proxy;
  }

  const double ofSprings = springDamping();
  const double wanted = ofSprings + (out.isContact ? m_feel.surface->damping : 0.0);
  // Half of what the device can carry leaves as much for the springs.
  const double damping = std::min(wanted, 0.5 * tip.dampingLimit);
  const double room = damping > 0.0 ? 1.0 - damping / tip.dampingLimit : 1.0;
  const double stiff = slope();
  const double most = tip.stiffnessLimit * room;
  const double share = stiff > most ? most / stiff : 1.0;
  out.stiffness = share * stiff;
  out.isSoftened = share < 1.0 || damping < wanted;
  const double kept = wanted > 0.0 ? damping / wanted : 1.0;
  const Vec3 pulled = share * springForce(tip.position) - kept * ofSprings * tip.velocity;
  out.force = changedOver(pulled, share * pullSlope(), tip);
  if (out.isContact) {
    const double stiffness = share * m_feel.surface->stiffness;
    out.force += contactForce(contact, tip.position, tip.velocity, stiffness, kept * m_feel.surface->damping);
  }
}

// What the hand itself has done to the force since the tick before is no gap: it is no more than the slope times its
// way, taken twice for a velocity that comes late. Else scenes that are exchanged often would let the force lag behind.
Vec3 SceneForces::changedOver(const Vec3& pulled, double slope, const TipState& tip) {
  if (std::exchange(m_hasFollowed, false)) {
    const Vec3 gap = m_pulled - pulled;
    const double byHand = 2.0 * slope * tip.velocity.norm() * tip.period;
    m_gap = gap.norm() > byHand ? Vec3(gap * (1.0 - byHand / gap.norm())) : Vec3(Vec3::Zero());
    m_gapTime = kChangeOver;
  }
  m_pulled = pulled + m_gapTime / kChangeOver * m_gap;
  m_gapTime = std::max(0.0, m_gapTime - tip.period);
  return m_pulled;
}

// Outside of the sphere around the surface.
Vec3 SceneForces::entryOf(const Vec3& tip) const {
  if (!m_feel.surface || m_feel.comesFrom.isZero(0.0) || m_feel.surface->surface.empty()) return tip;
  const ContactSurface& surface = m_feel.surface->surface;
  const double far = (tip - surface.bounds().center()).norm() + 0.51 * surface.diagonal();
  const Vec3 entry = tip + far * m_feel.comesFrom;
  return entry.allFinite() ? entry : tip;
}

void SceneForces::touch(const TipState& tip) {
  if (m_feel.surface) m_god.follow(m_feel.surface->surface, tip.position, m_feel.surface->contact);
}

void SceneForces::snap(const TipState& tip) {
  if (!m_feel.snap) return;
  const SnapFeel& feel = *m_feel.snap;
  m_pull = feel.method == SnapMethod::Proxy ? m_snapProxy.step(feel.field, feel.profile, tip.position)
                                            : m_snapSum.step(feel.field, feel.profile, tip.position);
  // On the surface that is felt by itself; a magnet would make it harder than it is meant to be. Nothing leaps: where
  // the tip meets it, the force of the magnet is none.
  const bool isOnFacet = feel.method == SnapMethod::Proxy && isHeldBy(SnapKind::Facet);
  if (isOnFacet && m_feel.surface && m_god.contact().touching) {
    m_pull.force.setZero();
    m_pull.slope = 0.0;
  }
}

bool SceneForces::isHeldBy(SnapKind kind) const {
  return m_pull.featureCount > 0 && m_pull.features[0].kind == kind;
}

// N/mm: a bound of |dF/dx| of all that acts.
double SceneForces::slope() const {
  return pullSlope() + (m_feel.surface && m_god.contact().touching ? m_feel.surface->stiffness : 0.0);
}

// The same of springs and features alone.
double SceneForces::pullSlope() const {
  double sum = m_feel.snap ? m_pull.slope : 0.0;
  for (const SpringFeel& spring : m_feel.springs) sum += spring.stiffness;
  return sum;
}

double SceneForces::springDamping() const {
  double sum = 0.0;
  for (const SpringFeel& spring : m_feel.springs) sum += spring.damping;
  return sum;
}

Vec3 SceneForces::springForce(const Vec3& tip) const {
  Vec3 sum = m_feel.snap ? m_pull.force : Vec3(Vec3::Zero());
  for (const SpringFeel& spring : m_feel.springs) sum += spring.stiffness * (spring.target - tip);
  return sum;
}

}  // namespace handwheel
