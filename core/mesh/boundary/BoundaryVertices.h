// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Tolerance.h"
#include "mesh/structure/HalfEdgeMesh.h"
#include "proximity/TriangleHierarchy.h"

#include <utility>
#include <vector>

namespace handwheel {

// Returns the length of the bounding-box diagonal of all live faces. It is 0 for an empty mesh.
double modelDiagonal(const HalfEdgeMesh& mesh);

// Returns the distance below which boundary vertices count as one vertex. It is nearWeld times the diagonal, but not
// less than CoordinateSteps::reach(). It is 0 if nearWeld is, or if the square of the diagonal overflows.
double nearWeldReach(const HalfEdgeMesh& mesh, double nearWeld = tolerance::kNearWeld);

// A spatial search structure for the vertices on open boundaries.
class BoundaryVertices {
 public:
  // Vertices marked in "without" are left out; the list may be shorter than the number of vertices. The result is
  // invalid if cancelled.
  explicit BoundaryVertices(const HalfEdgeMesh& mesh, const std::vector<bool>& without = {}, Progress progress = {});

  std::size_t size() const { return m_vertices.size(); }
  const std::vector<Vertex>& all() const { return m_vertices; }

  // Calls visit(vertex) for each vertex in the box, boundaries included, and perhaps for some vertices just outside.
  template <class Visit>
  void forEachInBox(const Box& box, Visit visit) const {
    m_positions.forEachInBox(box, [&](std::uint32_t i) {
      visit(m_vertices[i]);
      return true;
    });
  }

 private:
  std::vector<Vertex> m_vertices;  // ascending
  TriangleHierarchy m_positions;   // one degenerate triangle per vertex
};

using VertexPairs = std::vector<std::pair<Vertex, Vertex>>;

// Finds pairs of boundary vertices that are close, but not at the same position. Their distance is below
// nearWeldReach() and below tolerance::kNearWeldEdge times the longer boundary edge at either vertex. Most such pairs
// are one vertex of a scan that the rounding of its file has separated. Each vertex is paired with the nearest one of
// smaller number. Vertices marked in "without" are ignored. Pairs are sorted by their second vertex. The result is
// invalid if cancelled.
VertexPairs nearBoundaryVertices(const HalfEdgeMesh& mesh, const std::vector<bool>& without = {},
                                 double nearWeld = tolerance::kNearWeld, Progress progress = {});

}  // namespace handwheel
