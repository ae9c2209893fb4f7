// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/holes/Patch.h"

namespace handwheel {

// Statistics to compare patches for the same hole.
struct PatchStatistics {
  std::size_t triangles = 0;
  double area = 0.0;         // mm²
  double largestBend = 0.0;  // radian: between the normals on the two sides of an edge, 0 for flat; the edges of the
                             // loop, with the faces of the mesh beyond, are among them
  double meanBend = 0.0;     // radian: RMS over the edges, longer ones counting for more
};

// Computes the statistics of a patch that closes a loop of a mesh. Edges at triangles without area are left out.
// O(n log n).
PatchStatistics statisticsOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch);

}  // namespace handwheel
