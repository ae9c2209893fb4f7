// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/repair/TriangleWalls.h"

namespace handwheel {

TriangleSoup wallsOf(const TriangleSoup& surface, double thickness) {
  TriangleSoup walls;
  for (const Triangle& t : surface.triangles) {
    const Vec3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    const Vec3 normal = (b - a).cross(c - a).stableNormalized();
    if (!normal.allFinite() || normal.isZero()) continue;
    const auto front = static_cast<std::uint32_t>(walls.points.size()), back = front + 3;
    for (const double side : {0.5, -0.5})
      for (const Vec3& p : {a, b, c}) walls.points.push_back(p + side * thickness * normal);
    walls.triangles.push_back({front, front + 1, front + 2});
    walls.triangles.push_back({back, back + 2, back + 1});
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t next = (k + 1) % 3;
      walls.triangles.push_back({back + k, back + next, front + next});
      walls.triangles.push_back({back + k, front + next, front + k});
    }
  }
  return walls;
}

WallMeasure measureForWalls(const TriangleSoup& surface) {
  WallMeasure measure;
  for (const Triangle& t : surface.triangles) {
    const Vec3 &a = surface.points[t[0]], &b = surface.points[t[1]], &c = surface.points[t[2]];
    const double area = 0.5 * (b - a).cross(c - a).norm();
    measure.area += area;
    if (area > 0.0) measure.edges += (b - a).norm() + (c - b).norm() + (a - c).norm();
  }
  return measure;
}

}  // namespace handwheel
