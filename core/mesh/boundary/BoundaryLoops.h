// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"
#include "mesh/structure/PositionTriangles.h"

#include <vector>

namespace handwheel {

// A closed chain of open half-edges that passes no position twice. Its half-edges are oriented as their faces, so a
// patch uses them in the opposite direction.
struct BoundaryLoop {
  int id = 0;                       // counted from 0 in ascending order of the smallest vertex
  std::vector<HalfEdge> halfEdges;  // in order; each ends at the position at which the next starts
  std::size_t borderEdges = 0;      // number of border edges; the other edges are seams (Open::Seam)
  double length = 0.0;              // mm
  double planarity = 0.0;           // RMS distance to the best plane / length
  double area = 0.0;                // mm², area of the largest projection
  std::size_t islands = 0;          // surface pieces inside the loop; set by countIslands()
  bool isSheetBoundary = false;     // true: the outer edge of an open sheet, not a hole in a surface
  Vec3 centre = Vec3::Zero();
  Box box;
};

// Finds the boundary loops of a mesh. Every border half-edge is in exactly one loop; loops of seams alone are left out.
// O(n log n). Returns an empty list if cancelled.
std::vector<BoundaryLoop> findBoundaryLoops(const HalfEdgeMesh& mesh, Progress progress = {});
std::vector<BoundaryLoop> findBoundaryLoops(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition,
                                            Progress progress = {});

// Returns the smallest vertex of a loop, which identifies the loop. It survives edits elsewhere and is unique in the
// mesh.
Vertex keyOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop);

// Returns the start point of each half-edge of a loop.
std::vector<Vec3> loopPoints(const HalfEdgeMesh& mesh, const BoundaryLoop& loop);

}  // namespace handwheel
