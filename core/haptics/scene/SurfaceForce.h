// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/GodObject.h"
#include "haptics/scene/ForceSource.h"

namespace handwheel {

// A touchable surface with its contact parameters.
struct TouchedSurface {
  ContactSurface surface;
  double stiffness = 0.5;  // N/mm; set by the fidelity setting contact.stiffness
  double damping = 0.0;    // N·s/mm, along the normal
  ContactOptions contact;
};

// The contact force of a triangle surface, by a god object. If the predecessor has a version of the same surface, the
// force continues from the predecessor's proxy, which is moved outside if an edit has buried it.
class SurfaceForce : public ForceSource {
 public:
  // comesFrom: the direction (unit vector, towards the viewer) from which the tip is assumed to approach when the tip
  // or the surface appears. So the proxy rests on the visible side of the surface, not inside the solid. Zero: no
  // direction is assumed.
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
