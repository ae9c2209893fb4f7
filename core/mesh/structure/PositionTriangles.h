// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"
#include "mesh/structure/Weld.h"

namespace handwheel {

// The faces of a mesh as a file stores them: over positions instead of vertices. Index i is face i; a dead face is a
// degenerate triangle that connects nothing.
struct PositionTriangles {
  // The object is invalid if cancelled.
  explicit PositionTriangles(const HalfEdgeMesh& mesh, Progress progress = {});

  PointClasses classes;             // classes of the mesh's vertices
  std::vector<Triangle> triangles;  // indices of classes
};

// Counts the edges that do not have exactly two faces in the file. These are open edges, and edges with more than two
// faces. O(n log n).
std::size_t countBadEdges(const HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
