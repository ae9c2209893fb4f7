// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/BoundaryVertices.h"

#include "mesh/boundary/CoordinateRounding.h"
#include "mesh/structure/CancelPolling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace handwheel {
namespace {

// Returns the largest distance that each vertex on an open boundary may move to another. It is a share of its longer
// boundary edge, so that fine detail of a large model does not collapse.
std::unordered_map<Vertex, double> reaches(const HalfEdgeMesh& mesh, double nearWeld, Progress progress) {
  std::unordered_map<Vertex, double> reach;
  const double most = nearWeldReach(mesh, nearWeld);
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (!pollProgress(h, mesh.halfEdgeSlots(), progress)) break;
    if (!mesh.isBorder(h)) continue;
    const double length = (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
    for (Vertex v : {mesh.from(h), mesh.to(h)}) {
      double& r = reach.try_emplace(v, 0.0).first->second;
      // The longer edge counts: the shorter one may result from a vertex that the file split.
      r = std::max(r, std::min(most, tolerance::kNearWeldEdge * length));
    }
  }
  return reach;
}

}  // namespace

double modelDiagonal(const HalfEdgeMesh& mesh) {
  Box box;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    for (Vertex v : mesh.triangle(f)) box.extend(mesh.position(v));
  }
  return box.isEmpty() ? 0.0 : box.diagonal().stableNorm();
}

double nearWeldReach(const HalfEdgeMesh& mesh, double nearWeld) {
  const double diagonal = modelDiagonal(mesh);
  if (!std::isfinite(diagonal * diagonal) || nearWeld <= 0.0) return 0.0;
  return std::max(nearWeld * diagonal, coordinateSteps(mesh).reach());
}

BoundaryVertices::BoundaryVertices(const HalfEdgeMesh& mesh, const std::vector<bool>& without, Progress progress) {
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (!pollProgress(h, mesh.halfEdgeSlots(), progress)) return;
    if (mesh.isBorder(h)) m_vertices.insert(m_vertices.end(), {mesh.from(h), mesh.to(h)});
  }
  std::sort(m_vertices.begin(), m_vertices.end());
  m_vertices.erase(std::unique(m_vertices.begin(), m_vertices.end()), m_vertices.end());
  std::erase_if(m_vertices, [&](Vertex v) { return v < without.size() && without[v]; });

  std::vector<Vec3> points;
  std::vector<Triangle> degenerate;
  for (std::uint32_t i = 0; i < m_vertices.size(); ++i) {
    points.push_back(mesh.position(m_vertices[i]));
    degenerate.push_back({i, i, i});
  }
  m_positions = TriangleHierarchy(points, degenerate);
}

VertexPairs nearBoundaryVertices(const HalfEdgeMesh& mesh, const std::vector<bool>& without, double nearWeld,
                                 Progress progress) {
  const BoundaryVertices vertices(mesh, without, progress.part(0.0, 0.3));
  const std::unordered_map<Vertex, double> reach = reaches(mesh, nearWeld, progress.part(0.3, 0.5));
  VertexPairs pairs;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (!pollProgress(i, vertices.size(), progress.part(0.5, 1.0), 1)) break;  // many may lie within the reach
    const Vertex v = vertices.all()[i];
    const Vec3 p = mesh.position(v);
    const double own = reach.at(v);
    double best = std::numeric_limits<double>::infinity();
    Vertex nearest = kNone;
    vertices.forEachInBox(Box(p - Vec3::Constant(own), p + Vec3::Constant(own)), [&](Vertex u) {
      if (u >= v) return;
      const double d = (mesh.position(u) - p).norm();
      if (d == 0.0 || d > std::min(own, reach.at(u)) || d > best || (d == best && u > nearest)) return;
      best = d;
      nearest = u;
    });
    if (nearest != kNone) pairs.emplace_back(nearest, v);
  }
  return pairs;
}

}  // namespace handwheel
