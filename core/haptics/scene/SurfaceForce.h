// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/GodObject.h"
#include "haptics/scene/ForceSource.h"

namespace handwheel {

// A touchable surface with its contact parameters.
struct TouchedSurface {
  ContactSurface surface;
  double stiffness = 0.5;  // N/mm: fidelity setting contact.stiffness
  double damping = 0.0;    // N·s/mm, along the normal
  ContactOptions contact;
};

// The contact force of a triangle surface, by a god object. On a version of the same surface it continues from its
// predecessor's proxy, moved outside if an edit has covered it.
class SurfaceForce : public ForceSource {
 public:
  // comesFrom: the direction (unit length, towards the viewer) from which the tip is assumed to approach when it
  // appears, or when the surface appears. So it rests on the surface that is visible there, not inside the solid. Zero:
  // no such assumption.
  SurfaceForce(std::string id, TouchedSurface touched, const Vec3& comesFrom = Vec3::Zero());

  void follow(const ForceSource& previous) noexcept override;
  ForceBounds advance(const TipState& tip, ForceOut& out) noexcept override;
  Vec3 force(const TipState& tip, double stiffness, double damping) noexcept override;

  const Contact& contact() const { return m_god.contact(); }

 private:
  Vec3 entryOf(const Vec3& tip) const;

  TouchedSurface m_touched;
  Vec3 m_comesFrom;
  GodObject m_god;
  bool m_isPlaced = false;
};

}  // namespace handwheel
