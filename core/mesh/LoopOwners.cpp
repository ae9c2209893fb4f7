// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/LoopOwners.h"

namespace handwheel {
namespace {

std::pair<Face, Vertex> key(const HalfEdgeMesh& mesh, HalfEdge h) {
  return {HalfEdgeMesh::face(h), mesh.from(HalfEdgeMesh::previous(h))};
}

}  // namespace

LoopOwners::LoopOwners(const HalfEdgeMesh& mesh, const std::vector<BoundaryLoop>& loops) {
  for (const BoundaryLoop& loop : loops) {
    for (HalfEdge h : loop.halfEdges) m_loopOf.emplace(key(mesh, h), loop.id);
  }
}

std::set<int> LoopOwners::of(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) const {
  std::set<int> ids;
  for (HalfEdge h : loop.halfEdges) {
    const auto at = m_loopOf.find(key(mesh, h));
    if (at != m_loopOf.end()) ids.insert(at->second);
  }
  return ids;
}

}  // namespace handwheel
