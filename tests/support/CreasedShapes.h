// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshShapes.h"

#include <random>

// Finely triangulated parts with sharp edges, and the distances of points from their true surfaces.
namespace handwheel::test {

// Returns a box from -1 to 1 in x and y and between two heights in z, with n cells along each side. Points inside its
// sides are moved at random within the sides, and points on its edges along the edges. seed: the seed of the random
// moves; 0: the points are not moved.
inline TriangleSoup roughBox(std::uint32_t n, double low, double high, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> number;
  TriangleSoup s;
  const auto coordinate = [&](std::uint32_t i, int axis) {
    const double shake = seed && i > 0 && i < n ? 0.5 * (random() / 4294967296.0 - 0.5) : 0.0;
    const double w = (i + shake) / n;
    return axis == 2 ? low + (high - low) * w : 2.0 * w - 1.0;
  };
  const auto at = [&](const std::array<std::uint32_t, 3>& cell) {
    const auto [found, isNew] = number.try_emplace(cell, static_cast<std::uint32_t>(s.points.size()));
    if (isNew) s.points.emplace_back(coordinate(cell[0], 0), coordinate(cell[1], 1), coordinate(cell[2], 2));
    return found->second;
  };
  for (int axis = 0; axis < 3; ++axis) {
    for (std::uint32_t end : {0u, n}) {
      for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
          const auto corner = [&](std::uint32_t di, std::uint32_t dj) {
            std::array<std::uint32_t, 3> cell{};
            cell[axis] = end;
            cell[(axis + 1) % 3] = i + di;
            cell[(axis + 2) % 3] = j + dj;
            return at(cell);
          };
          const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          const bool isTurned = end == 0;
          const auto add = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
            s.triangles.push_back(isTurned ? Triangle{x, z, y} : Triangle{x, y, z});
          };
          if ((i + j) % 2) {
            add(a, b, c);
            add(a, c, d);
          } else {
            add(a, b, d);
            add(b, c, d);
          }
        }
      }
    }
  }
  return s;
}

inline TriangleSoup roughCube(std::uint32_t n, std::uint32_t seed) {
  return roughBox(n, -1.0, 1.0, seed);
}

// Returns a slab a fifth as high as wide, so that a ball at its side intersects two edges.
inline TriangleSoup roughSlab(std::uint32_t n, std::uint32_t seed) {
  return roughBox(n, 0.0, 0.2, seed);
}

inline double distanceToCube(const Vec3& p) {
  const Vec3 q = p.cwiseAbs() - Vec3::Ones();
  return std::abs(q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0));
}

// Returns a cylinder of radius 1 around z, from z = -1 to 1, with n points around it. seed: the seed of random moves
// of its points; 0: the points are not moved.
inline TriangleSoup roughCylinder(std::uint32_t n, std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto shake = [&] { return seed ? 0.4 * (random() / 4294967296.0 - 0.5) : 0.0; };
  const std::uint32_t rows = n / 3;   // rows up the side; the cells are as wide as they are high
  const std::uint32_t rings = n / 6;  // rings from the rim inwards
  TriangleSoup s = grid(n, rows + 2 * rings + 1, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double turn = 2.0 * M_PI * (i + shake()) / n;
    double r = 1.0, z = 1.0;
    if (j < rings) {
      r = (j + 0.3 + (j ? shake() : 0.0)) / (rings + 0.3);
      z = -1.0;
    } else if (j <= rings + rows) {
      const bool isRim = j == rings || j == rings + rows;
      z = 2.0 * (j - rings + (isRim ? 0.0 : shake())) / rows - 1.0;
    } else {
      const std::uint32_t k = 2 * rings + rows - j;
      r = (k + 0.3 + (k ? shake() : 0.0)) / (rings + 0.3);
    }
    return Vec3(r * std::cos(turn), r * std::sin(turn), z);
  });
  const auto low = static_cast<std::uint32_t>(s.points.size()), high = low + 1, m = rows + 2 * rings + 1;
  s.points.insert(s.points.end(), {Vec3(0, 0, -1), Vec3(0, 0, 1)});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = i * m, b = (i + 1) % n * m;
    s.triangles.push_back({low, b, a});
    s.triangles.push_back({high, a + m - 1, b + m - 1});
  }
  return s;
}

inline double distanceToCylinder(const Vec3& p) {
  const double r = std::hypot(p.x(), p.y()) - 1.0, z = std::abs(p.z()) - 1.0;
  return std::abs(std::hypot(std::max(r, 0.0), std::max(z, 0.0)) + std::min(std::max(r, z), 0.0));
}

}  // namespace handwheel::test
