// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshShapes.h"

#include <map>

// Generated surfaces with only one side. Neighbouring triangles share points.
namespace handwheel::test {

// Returns a strip of n × m cells with half a turn. The orientations of its triangles agree except across one line of
// cells.
inline TriangleSoup moebiusStrip(std::uint32_t n, std::uint32_t m) {
  TriangleSoup s = grid(n + 1, m + 1, false, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2.0 * M_PI * i / n, v = 0.4 * (2.0 * j / m - 1.0), r = 1.0 + v * std::cos(u / 2.0);
    return Vec3(r * std::cos(u), r * std::sin(u), v * std::sin(u / 2.0));
  });
  for (Triangle& t : s.triangles)  // the last line of points is the first one, reversed
    for (std::uint32_t& v : t) v = v >= n * (m + 1) ? m - (v - n * (m + 1)) : v;
  s.points.resize(n * (m + 1));
  return s;
}

// Returns the "figure eight" immersion of a Klein bottle, which intersects itself. m must be even.
inline TriangleSoup kleinBottle(std::uint32_t n, std::uint32_t m) {
  TriangleSoup s = grid(n + 1, m, false, true, [&](std::uint32_t i, std::uint32_t j) {
    // v is shifted by half a cell, so that no point is on the curve where the figure eight crosses itself.
    const double u = 2.0 * M_PI * i / n, v = 2.0 * M_PI * (j + 0.5) / m;
    const double r = 2.0 + std::cos(u / 2.0) * std::sin(v) - std::sin(u / 2.0) * std::sin(2.0 * v);
    return Vec3(r * std::cos(u), r * std::sin(u),
                std::sin(u / 2.0) * std::sin(v) + std::cos(u / 2.0) * std::sin(2.0 * v));
  });
  for (Triangle& t : s.triangles)
    for (std::uint32_t& v : t) v = v >= n * m ? m - 1 - (v - n * m) : v;
  s.points.resize(n * m);
  return s;
}

// Returns a sphere with a cross-cap, which has only one side. A Möbius strip with the same outline replaces six
// triangles around a point; the path around the strip has three edges. The Euler characteristic is 1.
inline TriangleSoup sphereWithCrossCap(int levels) {
  TriangleSoup s = icosphere(levels);
  std::vector<std::uint32_t> count(s.points.size(), 0);
  for (const Triangle& t : s.triangles)
    for (const std::uint32_t v : t) ++count[v];
  const auto centre = static_cast<std::uint32_t>(std::find(count.begin(), count.end(), 6u) - count.begin());
  std::map<std::uint32_t, std::uint32_t> next;  // next vertex on the path around the point
  std::vector<Triangle> rest;
  for (const Triangle& t : s.triangles) {
    const auto k = static_cast<std::size_t>(std::find(t.begin(), t.end(), centre) - t.begin());
    if (k == 3) {
      rest.push_back(t);
    } else {
      next[t[(k + 1) % 3]] = t[(k + 2) % 3];
    }
  }
  s.triangles = rest;
  std::vector<std::uint32_t> ring = {next.begin()->first};
  while (ring.size() < 6) ring.push_back(next[ring.back()]);
  std::vector<std::uint32_t> core;
  for (std::size_t i = 0; i < 3; ++i) {
    core.push_back(static_cast<std::uint32_t>(s.points.size()));
    s.points.push_back(0.9 * s.points[centre] + 0.1 * s.points[ring[i]]);
  }
  for (std::size_t i = 0; i < 6; ++i) {
    const std::uint32_t a = ring[i], b = ring[(i + 1) % 6], p = core[i % 3], q = core[(i + 1) % 3];
    s.triangles.push_back({a, b, p});
    s.triangles.push_back({b, q, p});
  }
  return s;
}

}  // namespace handwheel::test
