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
  double area = 0.0;  // mm²
  // Largest angle between adjacent normals, radian, 0 if flat; includes the edges of the loop.
  double largestBend = 0.0;
  double meanBend = 0.0;  // radian: RMS over the edges, weighted by length
};

// Computes the statistics of a patch that closes a loop of a mesh. Edges of triangles without area are left out. O(n
// log n).
PatchStatistics statisticsOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch);

// The shape of a patch compared with the surface around its hole.
struct PatchComparison {
  double bend = 0.0;        // radian: largest bend of the patch, including the edges of the loop
  double bendAround = 0.0;  // radian: largest bend of three rings of faces around it
  double rise = 0.0;        // mm: excess of the patch over the height range of loop and rings above the loop's plane
  double size = 0.0;        // mm: diagonal of the loop's box; 0: not compared

  bool isKnown() const { return size > 0.0; }

  // Return true if the patch exceeds any continuation of its surroundings, so that the user should check it.
  bool bendsMore() const { return bend > bendAround + tolerance::kNoticeableBend; }
  bool risesMore() const { return rise > tolerance::kNoticeableRise * size; }
};

// Compares a patch with the surroundings of its loop in the mesh without it. O(n log n).
PatchComparison compared(const HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch);

}  // namespace handwheel
