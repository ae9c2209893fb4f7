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
  // Largest angle between adjacent normals, also across the edges of the loop, radian; 0 if flat.
  double largestBend = 0.0;
  double meanBend = 0.0;  // root mean square over the edges, weighted by length; radian
};

// Computes the statistics of a patch that closes a loop of a mesh. Edges of triangles without area are ignored. O(n log
// n).
PatchStatistics statisticsOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch);

// The shape of a patch compared with the surface around its hole.
struct PatchComparison {
  double bend = 0.0;        // largest bend of the patch, including the edges of the loop; radian
  double bendAround = 0.0;  // largest bend of three rings of faces around the patch; radian
  double rise = 0.0;        // excess of the patch's heights over those of loop and rings, from the loop's plane; mm
  double size = 0.0;        // diagonal of the loop's box, mm; 0: not compared

  bool isKnown() const { return size > 0.0; }

  // Return true if the patch bends or rises more than a continuation of its surroundings would, so that the user should
  // check the patch.
  bool bendsMore() const { return bend > bendAround + tolerance::kNoticeableBend; }
  bool risesMore() const { return rise > tolerance::kNoticeableRise * size; }
};

// Compares a patch with the surroundings of its loop in the mesh without the patch. O(n log n).
PatchComparison compared(const HalfEdgeMesh& mesh, const BoundaryLoop& loop, const Patch& patch);

}  // namespace handwheel
