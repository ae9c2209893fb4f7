// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/PatchStatistics.h"

#include "mesh/holes/HoleContext.h"
#include "mesh/structure/AngleBetween.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/FaceNormal.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

PatchComparison compared(const HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch) {
  PatchComparison result;
  result.bend = statisticsOf(mesh, loop, patch).largestBend;
  result.size = loop.box.diagonal().norm();
  const HoleContext hole = holeContext(mesh, loop);
  const EdgeTable edges(hole.ring, hole.points.size());
  const auto normalOf = [&](std::uint32_t halfEdge) {
    const Triangle& t = hole.ring[halfEdge / 3];
    return unitNormal({hole.points[t[0]], hole.points[t[1]], hole.points[t[2]]});
  };
  edges.forEachEdge([&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry> run) {
    if (run.size() != 2) return;
    const Vec3 one = normalOf(run[0].halfEdge), other = normalOf(run[1].halfEdge);
    if (!one.isZero() && !other.isZero()) result.bendAround = std::max(result.bendAround, angleBetween(one, other));
  });
  const Vec3 normal = hole.outward().stableNormalized();
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec3& p : hole.points) {
    const double height = (p - loop.centre).dot(normal);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  for (std::size_t i = patch.loopSize; i < patch.points.size(); ++i) {
    const double height = (patch.points[i] - loop.centre).dot(normal);
    result.rise = std::max({result.rise, height - high, low - height});
  }
  return result;
}

}  // namespace handwheel
