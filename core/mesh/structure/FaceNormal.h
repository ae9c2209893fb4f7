// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proximity/TriangleIntersection.h"

#include <algorithm>

namespace handwheel {

// Returns the unit normal of a triangle. It points to the side from which the corners run counter-clockwise; it is zero
// for a triangle without area, or so thin that rounding would determine the direction. Coordinates may have any finite
// size.
inline Vec3 unitNormal(const TrianglePoints& t) {
  // The edges are scaled first, so that the products neither overflow nor vanish. Halves are used because the
  // difference of two finite numbers may not be finite.
  Vec3 a = 0.5 * t[1] - 0.5 * t[0], b = 0.5 * t[2] - 0.5 * t[0];
  const double size = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  if (!(size > 0.0)) return Vec3::Zero();
  a /= size;
  b /= size;
  const Vec3 normal = a.cross(b);
  const double length = normal.norm();
  // Bound on the rounding error of the cross product, relative to the product of the lengths.
  constexpr double kRelativeRounding = 0x1p-50;
  return length > kRelativeRounding * a.norm() * b.norm() ? Vec3(normal / length) : Vec3(Vec3::Zero());
}

inline double areaOf(const TrianglePoints& t) {
  return 0.5 * (t[1] - t[0]).cross(t[2] - t[0]).norm();
}

}  // namespace handwheel
