// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proximity/TriangleIntersection.h"

#include <algorithm>

namespace handwheel {

// Tests whether a line intersects a triangle, its edges included. The line runs through p along the direction; it hits
// if the three triple products have the same sign (Segura and Feito 2001). Swapping two corners changes the sign
// exactly, so that neighbours agree on their common edge.
inline bool passesThrough(const Vec3& p, const Vec3& direction, const TrianglePoints& t) {
  // Largest rounding error of a triple product, as a share of the product of the lengths: a line that passes an edge or
  // a corner that triangles share must hit one of them.
  constexpr double kEdgeRounding = 1e-15;
  const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
  const double far = std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()});
  const double error = kEdgeRounding * direction.norm() * far;
  const double u = direction.dot(b.cross(c)), v = direction.dot(c.cross(a)), w = direction.dot(a.cross(b));
  // With one branch: six would often be mispredicted.
  return static_cast<bool>(((u >= -error) & (v >= -error) & (w >= -error)) |
                           ((u <= error) & (v <= error) & (w <= error)));
}

}  // namespace handwheel
