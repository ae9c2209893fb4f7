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
  int id = 0;                       // from 0, in order of the smallest vertex
  std::vector<HalfEdge> halfEdges;  // in order; the end of one has the position of the start of the next
  std::size_t borderEdges = 0;      // the rest are seams: edges that other faces share in the file
  double length = 0.0;              // mm
  double planarity = 0.0;           // RMS distance to the best plane / length
  double area = 0.0;                // mm², that it encloses as seen where that is largest
  std::size_t islands = 0;          // pieces of surface that lie in it; countIslands() sets it
  bool isSheetBoundary = false;     // the outer edge of an open sheet rather than a hole in a surface
  Vec3 centre = Vec3::Zero();
  Box box;
};

// Finds the boundary loops of a mesh. Every border half-edge is in exactly one loop; loops of seams alone are left out.
// O(n log n). Empty if cancelled.
std::vector<BoundaryLoop> findBoundaryLoops(const HalfEdgeMesh& mesh, Progress progress = {});
std::vector<BoundaryLoop> findBoundaryLoops(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition,
                                            Progress progress = {});

// The smallest vertex of a loop, which identifies it. It survives edits elsewhere; no two loops of a mesh share it.
Vertex keyOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop);

// The points of a loop: the start of each half-edge.
std::vector<Vec3> loopPoints(const HalfEdgeMesh& mesh, const BoundaryLoop& loop);

}  // namespace handwheel
