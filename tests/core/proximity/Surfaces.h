// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <cmath>
#include <map>
#include <random>
#include <vector>

// Generated surfaces for the tests and benchmarks of this folder.
namespace handwheel::test {

struct Surface {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;

  std::array<Vec3, 3> corners(std::size_t i) const {
    const Triangle& t = triangles[i];
    return {points[t[0]], points[t[1]], points[t[2]]};
  }

  void append(Surface other) {  // passed by value, since other may be this object
    const auto offset = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), other.points.begin(), other.points.end());
    for (const Triangle& t : other.triangles) triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
};

// Returns a closed sphere: an octahedron with each face cut into n² triangles, 8 n² in total. The radius varies by the
// fraction `bumps`.
inline Surface sphere(int n, const Vec3& centre = Vec3::Zero(), double radius = 1.0, double bumps = 0.0) {
  Surface s;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto vertex = [&](const std::array<int, 3>& grid) {
    const auto [at, isNew] = numbers.try_emplace(grid, static_cast<std::uint32_t>(s.points.size()));
    if (isNew) {
      const Vec3 d = Vec3(grid[0], grid[1], grid[2]).normalized();
      const double swell = std::sin(17 * d.x() + 1) * std::sin(13 * d.y() + 2) * std::sin(11 * d.z() + 3);
      s.points.push_back(centre + radius * (1.0 + bumps * swell) * d);
    }
    return at->second;
  };
  for (int octant = 0; octant < 8; ++octant) {
    const int x = octant & 1 ? -1 : 1, y = octant & 2 ? -1 : 1, z = octant & 4 ? -1 : 1;
    const auto at = [&](int i, int j) { return vertex({x * i, y * j, z * (n - i - j)}); };
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (x * y * z > 0)
        s.triangles.push_back({a, b, c});
      else
        s.triangles.push_back({a, c, b});
    };
    for (int i = 0; i < n; ++i)
      for (int j = 0; i + j < n; ++j) {
        add(at(i, j), at(i + 1, j), at(i, j + 1));
        if (i + j + 1 < n) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  return s;
}

// Returns random triangles in a cube of side 1. On a grid of the given number of steps, many triangles touch, coincide
// or have no area; without a grid (steps 0) they are in general position. `size` is the size of a triangle.
inline Surface soup(std::size_t count, double size, int steps, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
  const auto coordinate = [&](double v) { return steps > 0 ? std::round(v * steps) / steps : v; };
  Surface s;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 middle(uniform(0, 1), uniform(0, 1), uniform(0, 1));
    for (int k = 0; k < 3; ++k)
      s.points.push_back((middle + size * Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1))).unaryExpr(coordinate));
    const auto first = static_cast<std::uint32_t>(3 * i);
    s.triangles.push_back({first, first + 1, first + 2});
  }
  return s;
}

inline Surface moved(Surface s, double scale, const Vec3& shift) {
  for (Vec3& p : s.points) p = p * scale + shift;
  return s;
}

}  // namespace handwheel::test
