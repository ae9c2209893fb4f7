// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/simplify/VertexConstraints.h"

#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/FaceNormal.h"
#include "mesh/structure/Weld.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

// If one of the two remaining edges of the face of h is a crease, the edge that both become is a crease.
void mergeBehind(const HalfEdgeMesh& mesh, HalfEdge h, std::vector<std::uint8_t>& crease) {
  const HalfEdge one = HalfEdgeMesh::next(h), two = HalfEdgeMesh::previous(h);
  if (!mesh.hasOpposite(one) || !mesh.hasOpposite(two)) return;
  crease[mesh.opposite(one)] = crease[mesh.opposite(two)] = crease[one] | crease[two];
}

}  // namespace

VertexConstraints::VertexConstraints(const HalfEdgeMesh& mesh, bool keepBorders, std::optional<double> creaseAngle,
                                     Progress progress)
    : m_hold(mesh.vertexSlots(), VertexConstraint::Free), m_isUsed(mesh.vertexSlots(), false) {
  if (!holdOpenEdges(mesh, keepBorders, progress.part(0.0, 0.3))) return;
  holdSharedPositions(mesh, progress.part(0.3, 0.6));
  if (creaseAngle && !progress.cancelled()) holdCreases(mesh, *creaseAngle, progress.part(0.6, 1.0));
  m_isUsed = {};
}

bool VertexConstraints::holdOpenEdges(const HalfEdgeMesh& mesh, bool keepBorders, const Progress& progress) {
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (!pollProgress(h, mesh.halfEdgeSlots(), progress)) return false;
    if (!mesh.isProper(HalfEdgeMesh::face(h))) continue;
    m_isUsed[mesh.from(h)] = true;
    if (mesh.isSeam(h) || (keepBorders && mesh.isBorder(h))) {
      m_hold[mesh.from(h)] = m_hold[mesh.to(h)] = VertexConstraint::Fixed;
    }
  }
  return true;
}

void VertexConstraints::holdSharedPositions(const HalfEdgeMesh& mesh, const Progress& progress) {
  std::vector<Vec3> points;
  std::vector<Vertex> vertexOf;
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v) {
    if (!m_isUsed[v]) continue;
    points.push_back(mesh.position(v));
    vertexOf.push_back(v);
  }
  const PointClasses classes = classifyPoints(points, progress);
  if (progress.cancelled()) return;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const std::uint32_t first = classes.representative[classes.classOf[i]];
    if (first != i) m_hold[vertexOf[i]] = m_hold[vertexOf[first]] = VertexConstraint::Fixed;
  }
}

void VertexConstraints::holdCreases(const HalfEdgeMesh& mesh, double angle, const Progress& progress) {
  m_crease.assign(mesh.halfEdgeSlots(), 0);
  const double cosine = std::cos(angle);
  std::vector<std::uint32_t> ends(mesh.vertexSlots(), 0);
  std::vector<bool> isOpen(mesh.vertexSlots(), false);
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h) {
    if (!pollProgress(h, mesh.halfEdgeSlots(), progress)) return;
    if (!mesh.isProper(HalfEdgeMesh::face(h))) continue;
    if (!mesh.hasOpposite(h)) {
      isOpen[mesh.from(h)] = isOpen[mesh.to(h)] = true;
      continue;
    }
    const Vec3 a = unitNormal(mesh.points(HalfEdgeMesh::face(h)));
    const Vec3 b = unitNormal(mesh.points(HalfEdgeMesh::face(mesh.opposite(h))));
    if (a.isZero() || b.isZero() || a.dot(b) > cosine) continue;
    m_crease[h] = 1;
    ++ends[mesh.from(h)];
  }
  for (Vertex v = 0; v < ends.size(); ++v) {
    if (ends[v] == 0) continue;
    m_hold[v] = std::max(m_hold[v], ends[v] == 2 && !isOpen[v] ? VertexConstraint::Crease : VertexConstraint::Fixed);
  }
}

bool VertexConstraints::mergesCreases(const HalfEdgeMesh& mesh, HalfEdge h) const {
  if (m_crease.empty()) return false;
  const auto mergesIn = [&](HalfEdge g) {
    return m_crease[HalfEdgeMesh::next(g)] && m_crease[HalfEdgeMesh::previous(g)];
  };
  return mergesIn(h) || (mesh.hasOpposite(h) && mergesIn(mesh.opposite(h)));
}

void VertexConstraints::beforeCollapse(const HalfEdgeMesh& mesh, HalfEdge h) {
  VertexConstraint& kept = m_hold[mesh.from(h)];
  kept = std::max(kept, m_hold[mesh.to(h)]);
  if (m_crease.empty()) return;
  mergeBehind(mesh, h, m_crease);
  if (mesh.hasOpposite(h)) mergeBehind(mesh, mesh.opposite(h), m_crease);
}

}  // namespace handwheel
