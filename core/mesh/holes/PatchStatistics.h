// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Tolerance.h"
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

// How a patch compares with the surface around its hole.
struct PatchComparison {
  double bend = 0.0;        // radian: the largest of the patch, the edges of the loop included
  double bendAround = 0.0;  // and that of three rings of faces around
  double rise = 0.0;        // mm: how far the patch leaves the range of heights of loop and rings over the loop's plane
  double size = 0.0;        // mm: the diagonal of the loop's box; 0: not compared

  bool isKnown() const { return size > 0.0; }

  // More than any surface would that continues its surroundings: a person should look at it.
  bool bendsMore() const { return bend > bendAround + tolerance::kNoticeableBend; }
  bool risesMore() const { return rise > tolerance::kNoticeableRise * size; }
};

// Compares a patch with the surroundings of its loop in the mesh without it. O(n log n).
PatchComparison compared(const HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch);

}  // namespace handwheel
