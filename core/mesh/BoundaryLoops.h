// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// A closed chain of border half-edges, split where it passes the same position twice. Its half-edges run as their faces
// do, so a patch uses them the other way round.
struct BoundaryLoop {
  int id = 0;                        // from 0, in order of the smallest vertex
  std::vector<HalfEdge> halfEdges;   // in order; the end of one has the position of the start of the next
  double length = 0.0;               // mm
  double planarity = 0.0;            // RMS distance to the best plane / length
  bool rim = false;                  // the outer edge of an open sheet rather than a hole in a surface
  Vec3 centre = Vec3::Zero();
  Box box;
};

// Every border half-edge is in exactly one loop. O(n).
std::vector<BoundaryLoop> findBoundaryLoops(const HalfEdgeMesh& mesh);

}  // namespace handwheel
