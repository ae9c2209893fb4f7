// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <optional>
#include <vector>

namespace handwheel {

// The constraints on a vertex during simplification, in order of strength.
enum class VertexConstraint : std::uint8_t {
  Free,
  Crease,  // stays on its two sharp edges
  Fixed,
};

// The constraints of vertices while edges of a mesh collapse. They apply to vertices at seams, at positions that
// several vertices share, and, if requested, at borders and creases.
class VertexConstraints {
 public:
  // creaseAngle is the smallest angle between the normals at a crease (radian). The object is invalid if cancelled.
  VertexConstraints(const HalfEdgeMesh& mesh, bool keepBorders, std::optional<double> creaseAngle, Progress progress);

  void fix(Vertex v) { m_hold[v] = VertexConstraint::Fixed; }
  VertexConstraint of(Vertex v) const { return m_hold[v]; }
  bool isCrease(HalfEdge h) const { return !m_crease.empty() && m_crease[h]; }

  // Returns true if two creases would become one when the edge collapses.
  bool mergesCreases(const HalfEdgeMesh& mesh, HalfEdge h) const;
  // Transfers constraints to the vertex and the edges that remain. Must be called before collapseEdge().
  void beforeCollapse(const HalfEdgeMesh& mesh, HalfEdge h);

 private:
  bool holdOpenEdges(const HalfEdgeMesh& mesh, bool keepBorders, const Progress& progress);
  void holdSharedPositions(const HalfEdgeMesh& mesh, const Progress& progress);
  void holdCreases(const HalfEdgeMesh& mesh, double angle, const Progress& progress);

  std::vector<VertexConstraint> m_hold;  // constraint of each vertex
  std::vector<bool> m_isUsed;            // vertices that faces use; only during construction
  std::vector<std::uint8_t> m_crease;    // marks of crease half-edges; empty if creases are not kept
};

}  // namespace handwheel
