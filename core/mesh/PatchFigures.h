// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/BoundaryLoops.h"
#include "mesh/Patch.h"

namespace handwheel {

// By what patches for the same hole are compared.
struct PatchFigures {
  std::size_t triangles = 0;
  double area = 0.0;         // mm²
  double largestBend = 0.0;  // radian: between the normals on the two sides of an edge, 0 for flat; the edges of the
                             // loop, with the faces of the mesh beyond, are among them
  double meanBend = 0.0;     // radian: RMS over the edges, longer ones counting for more
};

// Of a patch that closes a loop of this mesh. Edges at triangles without area are left out. O(n log n).
PatchFigures figuresOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch);

}  // namespace handwheel
