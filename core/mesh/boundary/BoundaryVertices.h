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

// The length of the bounding-box diagonal of all live faces. 0 for an empty mesh.
double modelDiagonal(const HalfEdgeMesh& mesh);

// The distance below which boundary vertices count as one vertex. This share of the diagonal; 0 where the model is so
// large that its square is not finite.
double nearWeldReach(const HalfEdgeMesh& mesh, double nearWeld = tolerance::kNearWeld);

// A spatial search structure for the vertices on open boundaries.
class BoundaryVertices {
 public:
  // Vertices marked in "without" are left out; it may be shorter than the number of vertices. The result is invalid if
  // cancelled.
  explicit BoundaryVertices(const HalfEdgeMesh& mesh, const std::vector<bool>& without = {}, Progress progress = {});

  std::size_t size() const { return m_vertices.size(); }
  const std::vector<Vertex>& all() const { return m_vertices; }

  // Calls visit(vertex) for each vertex in the box, boundaries included, and perhaps for some just outside.
  template <class Visit>
  void forEachInBox(const Box& box, Visit visit) const {
    m_places.forEachInBox(box, [&](std::uint32_t i) {
      visit(m_vertices[i]);
      return true;
    });
  }

 private:
  std::vector<Vertex> m_vertices;  // ascending
  TriangleHierarchy m_places;      // each as a triangle that is a point
};

using VertexPairs = std::vector<std::pair<Vertex, Vertex>>;

// Finds pairs of boundary vertices that are close, but not at the same position. They are nearer than nearWeldReach()
// and than tolerance::kNearWeldEdge of the longer boundary edge at either: most often one vertex of the scan, separated
// by the rounding of its file. Each is paired with its nearest of smaller number. Vertices marked in "without" are
// ignored. By rising second vertex. The result is invalid if cancelled.
VertexPairs nearBoundaryVertices(const HalfEdgeMesh& mesh, const std::vector<bool>& without = {},
                                 double nearWeld = tolerance::kNearWeld, Progress progress = {});

}  // namespace handwheel
