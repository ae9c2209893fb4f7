// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/NearbyTriangles.h"

namespace handwheel {

// Contact parameters: friction, rest tolerance and step limit.
struct ContactOptions {
  double friction = 0.0;  // Coulomb's µ, the same for static and sliding friction
  // A proxy that would move by less than this fraction of the surface's diagonal is at rest. Set by the fidelity
  // setting proxy.tolerance.
  double tolerance = 1e-9;
  // Largest number of steps of the proxy in one tick; the remaining steps follow in the next tick. It is not a fidelity
  // setting, because no motion of a hand needs so many steps (GodObjectAccuracyTest).
  int maxSteps = 64;
};

// State of the contact between the device tip and a surface.
struct Contact {
  Vec3 proxy = Vec3::Zero();   // mm; on the surface while touching, otherwise at the tip
  Vec3 normal = Vec3::Zero();  // unit vector from the tip to the proxy; zero while not touching
  double depth = 0.0;          // mm; distance from the tip to the proxy
  bool touching = false;
};

// God object: a proxy that follows the device tip without penetrating the surface. Zilles and Salisbury, "A
// constraint-based god-object method for haptic display", IROS 1995. In each tick the proxy moves to the point nearest
// to the tip, on a path that crosses no triangle from either side. A contact plane stays active while the proxy is
// where it met the plane, or directly above the triangle of the plane; otherwise it is released, so that the proxy
// slides out of concave corners. The proxy has no radius; its distance from the surface is ContactSurface::skin(). The
// triangles and planes found are reused in the next tick while the surface is the same. A god object is used on the
// servo thread. It neither allocates nor locks; a tick takes about a microsecond.
class GodObject {
 public:
  // Moves the proxy to the tip, as in free space.
  void place(const Vec3& tip);

  // Moves the proxy towards the tip. If the tip is not finite, the function does nothing.
  const Contact& follow(const ContactSurface& surface, const Vec3& tip, const ContactOptions& options);

  // Moves a proxy that an edit has buried to the front of the surface. Must be called after each edit of the surface.
  void surfaceChanged(const ContactSurface& surface);

  const Contact& contact() const { return m_contact; }

 private:
  void slide(const ContactSurface& surface, const Vec3& tip, const ContactOptions& options);
  bool stepOut(const ContactSurface& surface, const Vec3& tip, double friction);

  Contact m_contact;
  Vec3 m_proxy = Vec3::Zero();  // always off the surface, even if the tip rests within the skin distance
  Vec3 m_tip = Vec3::Zero();
  NearbyTriangles m_faces;
  ContactPlanes m_planes;  // contact planes at the proxy
  bool m_wound = true;     // true: the proxy is on the outer side of the surface (TouchedFace::wound)
};

// Returns the contact force on the tip, N, as that of a spring and damper. F = k (Pp - Ph) - ζ V (He 2008, eq. 3-4),
// with the proxy Pp, the tip Ph, k in N/mm, ζ in N·s/mm, and the velocity V of the tip in mm/s. Only the normal
// component of the velocity counts. The force is zero while not touching, and never pulls into the surface.
Vec3 contactForce(const Contact& contact, const Vec3& tip, const Vec3& velocity, double stiffness, double damping);

}  // namespace handwheel
