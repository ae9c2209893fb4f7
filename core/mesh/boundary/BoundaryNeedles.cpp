// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/BoundaryNeedles.h"

#include "base/Tolerance.h"

#include <algorithm>

namespace handwheel {

std::vector<Face> findBoundaryNeedles(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, double reach) {
  const auto length = [&](HalfEdge h) { return (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm(); };
  std::vector<Face> needles;
  for (const BoundaryLoop& loop : loops) {
    for (std::size_t i = 0; i < loop.halfEdges.size(); ++i) {
      const HalfEdge h = loop.halfEdges[i], next = HalfEdgeMesh::next(h);
      if (loop.halfEdges[(i + 1) % loop.halfEdges.size()] != next || !mesh.hasOpposite(HalfEdgeMesh::next(next)))
        continue;
      const auto [shorter, longer] = std::minmax({length(h), length(next)});
      if (shorter < reach && shorter < tolerance::kNearWeldEdge * longer) needles.push_back(HalfEdgeMesh::face(h));
    }
  }
  return needles;
}

}  // namespace handwheel
