// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fidelity/CaseShapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace handwheel {

SoupSource sphereSource(int levels, double radius) {
  return [=] { return std::make_shared<const TriangleSoup>(sphereSoup(levels, radius)); };
}

SoupSource torusSource(std::uint32_t rounds, std::uint32_t sides, double radius, double tube) {
  return [=] { return std::make_shared<const TriangleSoup>(torusSoup(rounds, sides, radius, tube)); };
}

TriangleSoup sphereSoup(int levels, double radius) {
  constexpr double g = std::numbers::phi;
  TriangleSoup s;
  s.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
              {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (Vec3& p : s.points) p *= radius / p.norm();
  s.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(s.points.size()));
      if (isNew) s.points.push_back((s.points[a] + s.points[b]).normalized() * radius);
      return at->second;
    };
    std::vector<Triangle> finer;
    finer.reserve(4 * s.triangles.size());
    for (const Triangle& t : s.triangles) {
      const std::uint32_t a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], a, c}, {t[1], b, a}, {t[2], c, b}, {a, b, c}});
    }
    s.triangles = std::move(finer);
  }
  return s;
}

TriangleSoup torusSoup(std::uint32_t rounds, std::uint32_t sides, double radius, double tube) {
  TriangleSoup s;
  for (std::uint32_t i = 0; i < rounds; ++i) {
    for (std::uint32_t j = 0; j < sides; ++j) {
      const double u = 2.0 * M_PI * i / rounds, v = 2.0 * M_PI * j / sides, r = radius + tube * std::cos(v);
      s.points.emplace_back(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
    }
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return (i % rounds) * sides + j % sides; };
  for (std::uint32_t i = 0; i < rounds; ++i) {
    for (std::uint32_t j = 0; j < sides; ++j) {
      s.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      s.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return s;
}

double distanceToTorus(const Vec3& p, double radius, double tube) {
  return std::abs(std::hypot(std::hypot(p.x(), p.y()) - radius, p.z()) - tube);
}

}  // namespace handwheel
