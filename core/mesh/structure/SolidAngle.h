// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proximity/TriangleIntersection.h"

#include <cmath>

namespace handwheel {

// Returns the solid angle of a triangle seen from a point. It is positive if seen from behind the triangle. The sum
// over a closed surface is 4π times its winding number at the point (van Oosterom and Strackee, "The Solid Angle of a
// Plane Triangle", 1983).
inline double solidAngle(const TrianglePoints& t, const Vec3& from) {
  const Vec3 a = t[0] - from, b = t[1] - from, c = t[2] - from;
  const double u = a.norm(), v = b.norm(), w = c.norm();
  return 2.0 * std::atan2(a.dot(b.cross(c)), u * v * w + a.dot(b) * w + b.dot(c) * u + c.dot(a) * v);
}

}  // namespace handwheel
