// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/scene/SurfaceForce.h"

namespace handwheel {

SurfaceForce::SurfaceForce(std::string id, TouchedSurface touched, const Vec3& comesFrom)
    : ForceSource(std::move(id)), m_touched(std::move(touched)), m_comesFrom(comesFrom) {}

// The proxy begins at the tip in front of another surface.
void SurfaceForce::follow(const ForceSource& previous) noexcept {
  const auto* other = dynamic_cast<const SurfaceForce*>(&previous);
  if (!other || !other->m_isPlaced || !m_touched.surface.isVersionOf(other->m_touched.surface)) return;
  m_god = other->m_god;
  m_isPlaced = true;
  m_god.surfaceChanged(m_touched.surface);
}

ForceBounds SurfaceForce::advance(const TipState& tip, ForceOut& out) noexcept {
  if (tip.isRestart || !m_isPlaced) m_god.place(entryOf(tip.position));
  m_isPlaced = m_god.contact().proxy.allFinite();  // else at the next tip that is finite
  const Contact& contact = m_god.follow(m_touched.surface, tip.position, m_touched.contact);
  if (!contact.touching) return {};
  out.isContact = true;
  out.proxy = contact.proxy;
  return {m_touched.stiffness, m_touched.damping};
}

Vec3 SurfaceForce::force(const TipState& tip, double stiffness, double damping) noexcept {
  return contactForce(m_god.contact(), tip.position, tip.velocity, stiffness * m_touched.stiffness,
                      damping * m_touched.damping);
}

// Returns a point outside of the sphere around the surface.
Vec3 SurfaceForce::entryOf(const Vec3& tip) const {
  const ContactSurface& surface = m_touched.surface;
  if (m_comesFrom.isZero(0.0) || surface.empty()) return tip;
  const double far = (tip - surface.bounds().center()).norm() + 0.51 * surface.diagonal();
  const Vec3 entry = tip + far * m_comesFrom;
  return entry.allFinite() ? entry : tip;
}

}  // namespace handwheel
