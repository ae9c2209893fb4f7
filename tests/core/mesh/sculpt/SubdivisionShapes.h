// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/MeshBuilder.h"

#include <cmath>

namespace handwheel::test {

inline HalfEdgeMesh built(const TriangleSoup& soup) {
  return buildMesh(soup).mesh;
}

// Returns a fan of n triangles around the origin. The origin is its last point.
inline TriangleSoup fan(std::uint32_t n) {
  TriangleSoup soup;
  for (std::uint32_t j = 0; j < n; ++j) {
    soup.points.emplace_back(std::cos(2.0 * M_PI * j / n), std::sin(2.0 * M_PI * j / n), 0.0);
    soup.triangles.push_back({n, j, (j + 1) % n});
  }
  soup.points.push_back(Vec3::Zero());
  return soup;
}

}  // namespace handwheel::test
