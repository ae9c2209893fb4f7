// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/ContactSurface.h"

namespace handwheel {

// A bumpy ball around the origin and a circular path below its surface. The seed chooses the circle. The bumps are so
// smooth that each point of the path has only one nearest point on the surface.
class BumpySphere {
 public:
  explicit BumpySphere(std::uint64_t seed);

  const ContactSurface& surface() const { return m_surface; }
  Vec3 above() const { return 1.5 * tipAt(0.0); }  // a point outside the ball, above the start of the path; mm
  Vec3 tipAt(double distance) const;               // mm

 private:
  ContactSurface m_surface;
  Vec3 m_along, m_across;  // unit vectors
};

}  // namespace handwheel
