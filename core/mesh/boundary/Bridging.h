// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/FaceJoining.h"

#include <vector>

namespace handwheel {

// A pair of border points, each given by the open half-edge that leaves it.
struct BoundaryPair {
  HalfEdge a = kNone;
  HalfEdge b = kNone;
};

// The previous open half-edge: it ends where this open one starts.
HalfEdge previousOpen(const HalfEdgeMesh& mesh, HalfEdge h);

// The bounding box of all that a bridge or weld between two points affects. It contains the faces around the two border
// points and around their neighbours on the border.
Box reachOf(const HalfEdgeMesh& mesh, const BoundaryPair& ends);

// Triangles that bridge a hole, or why there are none.
struct Bridge {
  JoinProblem problem = JoinProblem::None;
  std::vector<Triangle> triangles;  // two; one where the points are two edges apart
};

// Finds two triangles that bridge a hole between two border points. Each has a border edge at one of the points, and
// the line between the points is one of their edges (He 2008, section 4.1.4): the surface stays manifold, the hole
// falls into two, or an island is connected to the rim. Of the possible pairs the one whose triangles are best shaped
// and bend least against their neighbours is taken. near: of this very mesh. The problem is that of the last pair tried
// when none is free.
Bridge findBridge(const FaceLocator& near, const BoundaryPair& ends);

}  // namespace handwheel
