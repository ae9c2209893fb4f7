// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <map>
#include <set>

namespace handwheel::test {

// Returns true if a surface is closed, oriented and manifold. Each edge must be used once in each direction, and the
// triangles around each point must form one ring.
inline bool isClosedManifold(const TriangleSoup& soup) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> passed;
  std::map<std::uint32_t, std::map<std::uint32_t, std::uint32_t>> rings;
  for (const Triangle& t : soup.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      if (!passed.emplace(t[k], t[(k + 1) % 3]).second) return false;
      if (!rings[t[k]].emplace(t[(k + 1) % 3], t[(k + 2) % 3]).second) return false;
    }
  for (const auto& [from, to] : passed)
    if (!passed.contains({to, from})) return false;
  for (const auto& [point, ring] : rings) {
    std::size_t length = 0;
    for (std::uint32_t at = ring.begin()->first; length == 0 || at != ring.begin()->first; ++length) at = ring.at(at);
    if (length != ring.size()) return false;
  }
  return rings.size() == soup.points.size();
}

// Returns the signed volume inside a closed surface.
inline double enclosed(const TriangleSoup& soup) {
  double six = 0.0;
  for (const Triangle& t : soup.triangles) six += soup.points[t[0]].dot(soup.points[t[1]].cross(soup.points[t[2]]));
  return six / 6.0;
}

}  // namespace handwheel::test
