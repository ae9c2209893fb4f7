// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HalfEdgeMesh.h"
#include "mesh/Weld.h"

namespace handwheel {

// The live faces of a mesh as a file shows them: over positions instead of vertices. Index i is face i; a dead face
// stands as a degenerate triangle that joins nothing.
struct PositionTriangles {
  // Of no use once cancelled.
  explicit PositionTriangles(const HalfEdgeMesh& mesh, Progress progress = {});

  PointClasses classes;             // of the mesh's vertices
  std::vector<Triangle> triangles;  // over classes
};

// How many edges the file will have that have not two faces: open ones, and those where more meet. O(n log n).
std::size_t countBadEdges(const HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
