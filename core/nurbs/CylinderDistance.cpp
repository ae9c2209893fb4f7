// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/CylinderDistance.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

using Corners = std::array<Vec3, 3>;

double cross(const Vec3& a, const Vec3& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Returns the distance of the axis to a triangle, projected along the axis.
double distanceFromAxis(const Corners& p) {
  double distance = HUGE_VAL;
  int left = 0, right = 0;  // sides on which the axis lies
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &a = p[k], &b = p[(k + 1) % 3];
    const Eigen::Vector2d edge = (b - a).head<2>();
    const double length = edge.squaredNorm();
    const double along = length > 0.0 ? std::clamp(-a.head<2>().dot(edge) / length, 0.0, 1.0) : 0.0;
    distance = std::min(distance, (a.head<2>() + along * edge).norm());
    left += cross(a, b) > 0.0;
    right += cross(a, b) < 0.0;
  }
  return left == 3 || right == 3 ? 0.0 : distance;
}

// The radius of a triangle takes every value between those at its nearest and its furthest point, and so does the
// height; the distance to each of the three sheets, the mantle and the ends, is largest at one of them.
double distanceToSheets(const Corners& p, double radius, double low, double high) {
  const double inside = radius - distanceFromAxis(p);
  const double outside = std::max({p[0].head<2>().norm(), p[1].head<2>().norm(), p[2].head<2>().norm()}) - radius;
  const auto [least, most] = std::minmax({p[0].z(), p[1].z(), p[2].z()});
  const double beyond = std::max({0.0, low - least, most - high});
  const double overhang = std::max(0.0, outside);
  const double fromMantle = std::hypot(std::max(inside, overhang), beyond);
  const double fromLow = std::hypot(std::max(std::abs(least - low), std::abs(most - low)), overhang);
  const double fromHigh = std::hypot(std::max(std::abs(least - high), std::abs(most - high)), overhang);
  return std::min({fromMantle, fromLow, fromHigh});
}

}  // namespace

double distanceToCylinder(const TriangleSoup& soup, const StockCylinder& cylinder) {
  double furthest = 0.0;
  for (const Triangle& t : soup.triangles) {
    const Corners p = {soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]};
    furthest = std::max(
        furthest, distanceToSheets(p, cylinder.diameter / 2.0, cylinder.position, cylinder.position + cylinder.length));
  }
  return furthest;
}

}  // namespace handwheel
