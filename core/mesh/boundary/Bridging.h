// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/FaceJoining.h"

#include <vector>

namespace handwheel {

// A pair of border points, each given by the open half-edge that starts there.
struct BoundaryPair {
  HalfEdge a = kNone;
  HalfEdge b = kNone;
};

// Returns the previous open half-edge, which ends at the start of h.
HalfEdge previousOpen(const HalfEdgeMesh& mesh, HalfEdge h);

// Returns the bounding box of all faces that a bridge or weld between two points affects. These are the faces around
// the two border points and around their neighbours on the border.
Box reachOf(const HalfEdgeMesh& mesh, const BoundaryPair& ends);

// Triangles that bridge a hole, or the reason why there are none.
struct Bridge {
  JoinProblem problem = JoinProblem::None;
  std::vector<Triangle> triangles;  // two, or one if the points are two edges apart
};

// Finds two triangles that bridge a hole between two border points. Each triangle has a border edge at one of the
// points, and the line between the points is one of their edges (He 2008, section 4.1.4). The surface stays manifold;
// the hole is divided into two, or an island is connected to the rim. Among the possible pairs, the best-shaped
// triangles with the smallest bend to their neighbours are chosen. near must be built from the mesh of the points. If
// every pair is obstructed, the problem is that of the last one tried.
Bridge findBridge(const FaceLocator& near, const BoundaryPair& ends);

}  // namespace handwheel
