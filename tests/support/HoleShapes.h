// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshShapes.h"

#include <array>

// Flat plates with holes cut into them.
namespace handwheel::test {

// Returns size × size unit squares around the origin in z = 0, facing up. Triangles whose centre (x, y) satisfies
// isHole(x, y) are omitted.
template <class IsHole>
TriangleSoup plateWithout(std::uint32_t size, IsHole isHole) {
  TriangleSoup s = grid(size + 1, size + 1, false, false,
                        [&](std::uint32_t i, std::uint32_t j) { return Vec3(i - 0.5 * size, j - 0.5 * size, 0.0); });
  std::erase_if(s.triangles, [&](const Triangle& t) {
    const Vec3 middle = (s.points[t[0]] + s.points[t[1]] + s.points[t[2]]) / 3.0;
    return isHole(middle.x(), middle.y());
  });
  return s;
}

// Returns a plate of 20 × 20 with a round hole of radius 6 around the origin, and an island of radius 2 in the hole.
inline TriangleSoup plateWithIsland() {
  return plateWithout(20, [](double x, double y) { return std::hypot(x, y) < 6.0 && std::hypot(x, y) > 2.0; });
}

// Returns a plate of 20 × 20 with a square hole of side 12, and a tongue of 2 × 8 from the left side of the hole.
inline TriangleSoup plateWithTongue() {
  return plateWithout(20, [](double x, double y) {
    return std::max(std::abs(x), std::abs(y)) < 6.0 && !(std::abs(y) < 1.0 && x < 2.0);
  });
}

// Returns a plate of 10 × 10 with a square hole of side 4.
inline TriangleSoup plateWithHole() {
  return plateWithout(10, [](double x, double y) { return std::max(std::abs(x), std::abs(y)) < 2.0; });
}

// Returns a plate of 10 × 10 with two square holes of side 2 that touch at the origin.
inline TriangleSoup plateWithPinchedHole() {
  return plateWithout(10, [](double x, double y) { return std::max(std::abs(x), std::abs(y)) < 2.0 && x * y > 0.0; });
}

// Returns the two triangles of cell (i, j) of a torus of 24 × 12 cells.
inline std::array<std::size_t, 2> torusCell(std::uint32_t i, std::uint32_t j) {
  return {2 * std::size_t(i * 12 + j), 2 * std::size_t(i * 12 + j) + 1};
}

// Returns a torus with two holes and slits whose sides are `gap` apart, mm. One hole is two squares of 3 × 3 cells that
// a slit of one edge joins; the other is a slit of two edges. When the sides are merged, the first hole becomes two
// holes, and the second one closes.
inline TriangleSoup torusWithSlits(double gap) {
  TriangleSoup s = torus(24, 12);
  const auto at = [](std::uint32_t i, std::uint32_t j) { return i * 12 + j; };
  // At each vertex of a slit, the cells on the side of the larger j get a vertex of their own.
  const auto slit = [&](std::uint32_t i, std::uint32_t j) {
    const Vec3 p = s.points[at(i, j)];
    const auto copy = static_cast<std::uint32_t>(s.points.size());
    s.points.push_back(p + gap * (s.points[at(i, j + 1)] - p).normalized());
    for (const std::uint32_t cell : {i - 1, i})
      for (const std::size_t t : torusCell(cell, j))
        std::replace(s.triangles[t].begin(), s.triangles[t].end(), at(i, j), copy);
  };
  slit(5, 3), slit(6, 3);
  slit(15, 8);
  std::set<std::size_t> open;
  for (const std::uint32_t first : {2u, 6u})
    for (std::uint32_t i = first; i < first + 3; ++i)
      for (std::uint32_t j = 2; j < 5; ++j)
        for (const std::size_t t : torusCell(i, j)) open.insert(t);
  TriangleSoup holed{s.points, {}};
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    if (!open.contains(t)) holed.triangles.push_back(s.triangles[t]);
  return holed;
}

}  // namespace handwheel::test
