// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshShapes.h"

// Flat plates with holes cut into them.
namespace handwheel::test {

// Size × size unit squares around the origin in z = 0, facing up, without the triangles whose middle isHole(x, y)
// picks.
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

// A hole of 6 around the origin in a plate of 20, with an island of 2 in it.
inline TriangleSoup plateWithIsland() {
  return plateWithout(20, [](double x, double y) { return std::hypot(x, y) < 6.0 && std::hypot(x, y) > 2.0; });
}

// A square hole of 12 in a plate of 20, with a tongue of 2 × 8 from its left side.
inline TriangleSoup plateWithTongue() {
  return plateWithout(20, [](double x, double y) {
    return std::max(std::abs(x), std::abs(y)) < 6.0 && !(std::abs(y) < 1.0 && x < 2.0);
  });
}

// A square hole of 4 in a plate of 10.
inline TriangleSoup plateWithHole() {
  return plateWithout(10, [](double x, double y) { return std::max(std::abs(x), std::abs(y)) < 2.0; });
}

// Two square holes of 2 in a plate of 10 that touch in the origin.
inline TriangleSoup plateWithPinchedHole() {
  return plateWithout(10, [](double x, double y) { return std::max(std::abs(x), std::abs(y)) < 2.0 && x * y > 0.0; });
}

}  // namespace handwheel::test
