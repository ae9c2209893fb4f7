// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proximity/TriangleIntersection.h"

#include <algorithm>

namespace handwheel {

// Tests whether a line intersects a triangle, including its edges. The line passes through p along the direction. It
// intersects the triangle if the three triple products have the same sign (Segura and Feito 2001). Swapping two corners
// exactly reverses the sign, so that neighbouring triangles agree on their common edge.
inline bool passesThrough(const Vec3& p, const Vec3& direction, const TrianglePoints& t) {
  // Largest rounding error of a triple product, relative to the product of the lengths. A line through an edge or
  // corner that triangles share must intersect at least one of them.
  constexpr double kEdgeRounding = 1e-15;
  const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
  const double far = std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()});
  const double error = kEdgeRounding * direction.norm() * far;
  const double u = direction.dot(b.cross(c)), v = direction.dot(c.cross(a)), w = direction.dot(a.cross(b));
  // There is one branch instead of six, which would often be mispredicted.
  return static_cast<bool>(((u >= -error) & (v >= -error) & (w >= -error)) |
                           ((u <= error) & (v <= error) & (w <= error)));
}

}  // namespace handwheel
