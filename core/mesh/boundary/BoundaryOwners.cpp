// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary/BoundaryOwners.h"

namespace handwheel {
namespace {

std::pair<Face, Vertex> faceKey(const HalfEdgeMesh& mesh, HalfEdge h) {
  return {HalfEdgeMesh::face(h), mesh.from(HalfEdgeMesh::previous(h))};
}

}  // namespace

BoundaryOwners::BoundaryOwners(const HalfEdgeMesh& mesh, const std::vector<BoundaryLoop>& loops) {
  for (const BoundaryLoop& loop : loops) {
    for (HalfEdge h : loop.halfEdges) {
      m_byFace.emplace(faceKey(mesh, h), loop.id);
      m_byPosition.emplace(positionKey(mesh, h), loop.id);
    }
  }
}

std::set<int> BoundaryOwners::of(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) const {
  std::set<int> ids;
  for (HalfEdge h : loop.halfEdges) {
    if (const auto at = m_byFace.find(faceKey(mesh, h)); at != m_byFace.end()) {
      ids.insert(at->second);
    } else if (const auto there = m_byPosition.find(positionKey(mesh, h)); there != m_byPosition.end()) {
      ids.insert(there->second);
    }
  }
  return ids;
}

}  // namespace handwheel
