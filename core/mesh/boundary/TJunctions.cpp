// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/TJunctions.h"

#include "mesh/boundary/BoundaryVertices.h"
#include "mesh/structure/CancelPolling.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace handwheel {
namespace {

// Edges are searched in pieces no longer than this share of the diagonal.
constexpr double kLongestPiece = 1.0 / 32.0;

bool isInSet(const std::vector<bool>& set, Vertex v) {
  return v < set.size() && set[v];
}

// Splits a border edge at a point: its face (a b c) keeps (a m c), the new face is (m b c). Only the distinction
// between border and inner edges stays valid; the mesh must be relinked afterwards.
void splitAt(HalfEdgeMesh& mesh, HalfEdge h, const Vec3& p) {
  const HalfEdge hn = HalfEdgeMesh::next(h);
  const Vertex b = mesh.to(h), c = mesh.to(hn);
  const HalfEdge behind = mesh.opposite(hn);
  const Vertex m = mesh.addVertex(p);
  mesh.setCorner(hn, m);
  const Face f = mesh.addFace({m, b, c});
  mesh.setOpposite(3 * f + 1, behind);
  mesh.pair(hn, 3 * f + 2);
}

// The position of a border vertex strictly inside the edge and within reach of it, nearest to its middle.
std::optional<Vec3> vertexOnEdge(const HalfEdgeMesh& mesh, HalfEdge h, const BoundaryVertices& vertices,
                                 double diagonal, double most) {
  const Vec3 a = mesh.position(mesh.from(h)), b = mesh.position(mesh.to(h));
  const Vec3 d = b - a;
  const double length = d.stableNorm();
  if (length == 0.0) return std::nullopt;
  const double reach = std::min(most, tolerance::kNearWeldEdge * length);
  const Vec3& apex = mesh.position(mesh.from(HalfEdgeMesh::previous(h)));
  std::optional<Vec3> best;
  double bestOffset = 0.5;
  const auto consider = [&](Vertex v) {
    const Vec3& p = mesh.position(v);
    const double t = (p - a).dot(d) / (length * length);
    if (t * length <= reach || (1.0 - t) * length <= reach) return;
    if ((p - (a + t * d)).norm() > reach || std::abs(t - 0.5) > bestOffset) return;
    if (isDegenerate({a, p, apex}) || isDegenerate({p, b, apex})) return;
    bestOffset = std::abs(t - 0.5);
    best = p;
  };
  // The edge is searched in pieces, because the box of a long slanting edge would contain much of the model.
  const auto pieces = static_cast<int>(std::ceil(length / (kLongestPiece * diagonal)));
  for (int i = 0; i < pieces; ++i) {
    const Vec3 begin = a + double(i) / pieces * d, end = a + double(i + 1) / pieces * d;
    const Vec3 slack = Vec3::Constant(reach);
    vertices.forEachInBox(Box(begin.cwiseMin(end) - slack, begin.cwiseMax(end) + slack), consider);
  }
  return best;
}

}  // namespace

std::size_t splitTJunctions(HalfEdgeMesh& mesh, const std::vector<bool>& fixed, Progress progress, double nearWeld) {
  const BoundaryVertices vertices(mesh, fixed, progress.part(0.0, 0.3));
  const double diagonal = modelDiagonal(mesh), nearest = nearWeldReach(mesh, nearWeld);
  std::size_t splits = 0;
  const std::size_t limit = 4 * vertices.size();  // each vertex splits few edges; a bound against endless splitting
  const std::size_t most = mesh.halfEdgeSlots() + 3 * limit;
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots() && splits < limit; ++h) {
    if (!pollProgress(h, most, progress.part(0.3, 1.0))) break;
    while (splits < limit && mesh.isBorder(h)) {
      if (progress.cancelled()) return splits;  // many may lie near a long edge
      if (isInSet(fixed, mesh.from(h)) || isInSet(fixed, mesh.to(h))) break;
      const std::optional<Vec3> p = vertexOnEdge(mesh, h, vertices, diagonal, nearest);
      if (!p) break;
      // The new face's half-edges are visited later in this very loop.
      splitAt(mesh, h, *p);
      ++splits;
    }
  }
  return splits;
}

}  // namespace handwheel
