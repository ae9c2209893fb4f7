// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshShapes.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/MeshBuilder.h"

#include <array>
#include <map>

namespace handwheel::test {

// Returns a ball with crossing faces around its hole. The points of the border of the hole on its top are moved to and
// fro along the border.
inline TriangleSoup withFoldedBorder(TriangleSoup ball) {
  const HalfEdgeMesh clean = buildMesh(ball).mesh;
  std::map<std::array<double, 3>, Vec3> moved;
  for (const BoundaryLoop& loop : findBoundaryLoops(clean)) {
    if (loop.centre.z() < 0.0) continue;
    const std::vector<Vec3> points = loopPoints(clean, loop);
    const std::size_t n = points.size() / 2 * 2;  // an even number, so that no two points coincide
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3& other = points[(i + (i % 2 == 0 ? 2 : n - 2)) % n];
      moved[{points[i].x(), points[i].y(), points[i].z()}] = (1.0 + 0.002 * static_cast<double>(1 + i % 3)) * other;
    }
  }
  for (Vec3& p : ball.points) {
    if (const auto at = moved.find({p.x(), p.y(), p.z()}); at != moved.end()) p = at->second;
  }
  return ball;
}

}  // namespace handwheel::test
