// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/LoopOwners.h"

#include <algorithm>

namespace handwheel {
namespace {

std::pair<Face, Vertex> faceKey(const HalfEdgeMesh& mesh, HalfEdge h) {
  return {HalfEdgeMesh::face(h), mesh.from(HalfEdgeMesh::previous(h))};
}

// The same for both directions of the edge.
std::array<double, 6> placeKey(const HalfEdgeMesh& mesh, HalfEdge h) {
  const Vec3 &p = mesh.position(mesh.from(h)), &q = mesh.position(mesh.to(h));
  const std::array<double, 3> a{p.x(), p.y(), p.z()}, b{q.x(), q.y(), q.z()};
  const auto& [low, high] = std::minmax(a, b);
  return {low[0], low[1], low[2], high[0], high[1], high[2]};
}

}  // namespace

LoopOwners::LoopOwners(const HalfEdgeMesh& mesh, const std::vector<BoundaryLoop>& loops) {
  for (const BoundaryLoop& loop : loops) {
    for (HalfEdge h : loop.halfEdges) {
      m_byFace.emplace(faceKey(mesh, h), loop.id);
      m_byPlace.emplace(placeKey(mesh, h), loop.id);
    }
  }
}

std::set<int> LoopOwners::of(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) const {
  std::set<int> ids;
  for (HalfEdge h : loop.halfEdges) {
    if (const auto at = m_byFace.find(faceKey(mesh, h)); at != m_byFace.end()) {
      ids.insert(at->second);
    } else if (const auto there = m_byPlace.find(placeKey(mesh, h)); there != m_byPlace.end()) {
      ids.insert(there->second);
    }
  }
  return ids;
}

}  // namespace handwheel
