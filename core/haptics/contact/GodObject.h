// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/NearbyTriangles.h"

namespace handwheel {

// Contact parameters: friction, rest tolerance and step limit.
struct ContactOptions {
  double friction = 0.0;  // Coulomb's µ, static and sliding alike
  // A proxy that would move less than this share of the surface's diagonal is at rest: fidelity setting
  // proxy.tolerance.
  double tolerance = 1e-9;
  // in one tick, the rest in the next; not a fidelity setting, as no hand needs as many (GodObjectAccuracyTest)
  int maxSteps = 64;
};

// State of the contact between the device tip and a surface.
struct Contact {
  Vec3 proxy = Vec3::Zero();   // mm; on the surface while touching, else at the tip
  Vec3 normal = Vec3::Zero();  // from the tip to the proxy, of length 1; zero while not touching
  double depth = 0.0;          // mm; distance from the tip to the proxy
  bool touching = false;
};

// God object: a proxy that follows the device tip without penetrating the surface. Zilles and Salisbury, "A
// constraint-based god-object method for haptic display", IROS 1995. Each tick the proxy moves to the point nearest to
// the tip, on a path that crosses no triangle from either side. Contact planes stay active while the proxy stays where
// it met them or directly above their triangles, and are released otherwise, so that it slides out of concave corners.
// It has no radius; its distance from the surface is ContactSurface::skin(). The triangles and planes found are reused
// in the next tick as long as it touches the same surface. Servo thread: neither allocates nor locks; about a
// microsecond.
class GodObject {
 public:
  // Puts the proxy at the tip, as in free space.
  void place(const Vec3& tip);

  // Moves the proxy towards the tip. Does nothing if the tip is not finite.
  const Contact& follow(const ContactSurface& surface, const Vec3& tip, const ContactOptions& options);

  // To be called after an edit of the surface: moves a proxy that is now behind the surface in front of it again.
  void surfaceChanged(const ContactSurface& surface);

  const Contact& contact() const { return m_contact; }

 private:
  void slide(const ContactSurface& surface, const Vec3& tip, const ContactOptions& options);
  bool stepOut(const ContactSurface& surface, const Vec3& tip, double friction);

  Contact m_contact;
  Vec3 m_proxy = Vec3::Zero();  // always off the surface, unlike a tip that rests within the skin
  Vec3 m_tip = Vec3::Zero();
  NearbyTriangles m_faces;
  ContactPlanes m_planes;  // at the proxy
  bool m_wound = true;     // the proxy touches the outside by winding order
};

// Returns the contact force on the tip, N, as a spring and damper. F = k (Pp - Ph) - ζ V (eq. 3-4): k in N/mm, ζ in
// N·s/mm, V the velocity of the tip in mm/s, of which only the normal component counts. Zero while not touching, and
// never a pull into the surface.
Vec3 contactForce(const Contact& contact, const Vec3& tip, const Vec3& velocity, double stiffness, double damping);

}  // namespace handwheel
