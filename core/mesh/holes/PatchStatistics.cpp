// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/PatchStatistics.h"

#include "mesh/structure/AngleBetween.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/FaceNormal.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
PatchStatistics statisticsOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch) {
  PatchStatistics statistics;
  statistics.triangles = patch.triangles.size();
  std::vector<Vec3> normals;
  for (const Triangle& t : patch.triangles) {
    const TrianglePoints points{patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]};
    statistics.area += 0.5 * (points[1] - points[0]).cross(points[2] - points[0]).norm();
    normals.push_back(unitNormal(points));
  }
  double length = 0.0, squares = 0.0;
  const EdgeTable edges(patch.triangles, patch.points.size());
  edges.forEachEdge([&](std::uint32_t low, std::uint32_t high, std::span<const EdgeTable::Entry> run) {
    const Vec3 one = normals[run[0].halfEdge / 3];
    Vec3 other = Vec3::Zero();
    if (run.size() == 2) {
      other = normals[run[1].halfEdge / 3];
    } else if (run.size() == 1 && high < patch.loopSize) {
      // The half-edge from point i of the loop to the next.
      const std::uint32_t start = high == low + 1 ? low : high;
      other = unitNormal(mesh.points(HalfEdgeMesh::face(loop.halfEdges[start])));
    }
    if (one.isZero() || other.isZero()) return;
    const double bend = angleBetween(one, other), weight = (patch.points[high] - patch.points[low]).norm();
    statistics.largestBend = std::max(statistics.largestBend, bend);
    squares += weight * bend * bend;
    length += weight;
  });
  if (length > 0.0) statistics.meanBend = std::sqrt(squares / length);
  return statistics;
}

}  // namespace handwheel
