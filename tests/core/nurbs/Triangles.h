// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace handwheel::test {

// Returns true if a triangulation is closed. Every edge must be in two triangles, once in each direction. Vertices are
// compared by number, since positions may coincide where a profile touches itself.
inline bool isClosed(const TriangleSoup& soup) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const Triangle& t : soup.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
  }
  return std::all_of(uses.begin(), uses.end(), [&](const auto& use) {
    const auto back = uses.find({use.first.second, use.first.first});
    return use.second == 1 && back != uses.end() && back->second == 1;
  });
}

// Returns the least angle of a triangle, in degrees.
inline double leastAngle(const TriangleSoup& soup, const Triangle& t) {
  double least = M_PI;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 &p = soup.points[t[k]], a = soup.points[t[(k + 1) % 3]] - p, b = soup.points[t[(k + 2) % 3]] - p;
    least = std::min(least, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return least * 180.0 / M_PI;
}

// Returns points all over a triangle, its corners included.
inline std::vector<Vec3> samples(const TriangleSoup& soup, const Triangle& t, int steps) {
  std::vector<Vec3> result;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; i + j <= steps; ++j)
      result.push_back((i * soup.points[t[0]] + j * soup.points[t[1]] + (steps - i - j) * soup.points[t[2]]) / steps);
  return result;
}

}  // namespace handwheel::test
