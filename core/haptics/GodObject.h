// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/LocalFaces.h"

namespace handwheel {

// What a touched surface is like.
struct ContactOptions {
  double friction = 0.0;  // Coulomb's µ, static and sliding alike
  // A proxy that would move less than this share of the surface's diagonal is at rest: fidelity setting
  // proxy.tolerance.
  double tolerance = 1e-9;
  int maxSteps = 64;  // in one tick; what is not reached by then is reached in the next
};

// Where a tip touches.
struct Contact {
  Vec3 proxy = Vec3::Zero();   // mm; on the surface while touching, else at the tip
  Vec3 normal = Vec3::Zero();  // from the tip to the proxy, of length 1; zero while not touching
  double depth = 0.0;          // mm; how far the tip is from the proxy
  bool touching = false;
};

// The point that a tip pushes over a surface and that never goes through it (Zilles and Salisbury, "A constraint-based
// god-object method for haptic display", IROS 1995): each tick it moves to where it is nearest to the tip, on a way
// that crosses no triangle from either side. Planes met are kept while the proxy stays where it met them or right over
// their triangles, and let go otherwise, so that it slides out of concave corners. It has no radius; it keeps off the
// surface by ContactSurface::skin(). What it has looked up and met serves the next tick as long as the surface is the
// same. Servo thread: neither allocates nor locks; about a microsecond.
class GodObject {
 public:
  // Puts the proxy at the tip, as in free space.
  void place(const Vec3& tip);

  // A tip that is not finite leaves everything as it is.
  const Contact& follow(const ContactSurface& surface, const Vec3& tip, const ContactOptions& options);

  // The surface has been edited: a proxy that has come to stand behind it is set before it again.
  void surfaceChanged(const ContactSurface& surface);

  const Contact& contact() const { return m_contact; }

 private:
  void slide(const ContactSurface& surface, const Vec3& tip, const ContactOptions& options);
  bool stepOut(const ContactSurface& surface, const Vec3& tip, double friction);

  Contact m_contact;
  Vec3 m_proxy = Vec3::Zero();  // off the surface, where a tip that rests within the skin is not
  Vec3 m_tip = Vec3::Zero();
  LocalFaces m_faces;
  ContactPlanes m_planes;  // at the proxy
  bool m_wound = true;     // it touches the side that the winding calls outside
};

// F = k (Pp - Ph) - ζ V (eq. 3-4), N: k in N/mm, ζ in N·s/mm, V the velocity of the tip in mm/s, of which the part
// along the normal counts. Zero while not touching, and never a pull into the surface.
Vec3 contactForce(const Contact& contact, const Vec3& tip, const Vec3& velocity, double stiffness, double damping);

}  // namespace handwheel
