// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HalfEdgeMesh.h"
#include "mesh/PositionTriangles.h"

#include <vector>

namespace handwheel {

// A closed chain of open half-edges that passes no position twice. Its half-edges run as their faces do, so a patch
// uses them the other way round.
struct BoundaryLoop {
  int id = 0;                       // from 0, in order of the smallest vertex
  std::vector<HalfEdge> halfEdges;  // in order; the end of one has the position of the start of the next
  std::size_t borderEdges = 0;      // the rest are seams: edges that other faces share in the file
  double length = 0.0;              // mm
  double planarity = 0.0;           // RMS distance to the best plane / length
  bool rim = false;                 // the outer edge of an open sheet rather than a hole in a surface
  bool picture = false;             // a rim of what is no body but a drawing or a view of one from one side
  Vec3 centre = Vec3::Zero();
  Box box;
};

// Every border half-edge is in exactly one loop; loops of seams alone are left out. O(n log n). Once
// cancelled, none.
std::vector<BoundaryLoop> findBoundaryLoops(const HalfEdgeMesh& mesh, Progress progress = {});
std::vector<BoundaryLoop> findBoundaryLoops(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition,
                                            Progress progress = {});

// A loop is known by its smallest vertex, which outlives edits elsewhere. No two loops of a mesh share it.
Vertex keyOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop);

// The start of each half-edge.
std::vector<Vec3> loopPoints(const HalfEdgeMesh& mesh, const BoundaryLoop& loop);

}  // namespace handwheel
