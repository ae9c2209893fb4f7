// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/FaceJoining.h"

#include <vector>

namespace handwheel {

// Two open half-edges, each standing for the point of the border that it leaves.
struct BorderPair {
  HalfEdge a = kNone;
  HalfEdge b = kNone;
};

// The open half-edge that arrives where this open one leaves.
HalfEdge previousOpen(const HalfEdgeMesh& mesh, HalfEdge h);

// The faces around two points of the border and around their neighbours on it: nothing that a bridge or a weld between
// them does reaches further.
Box reachOf(const HalfEdgeMesh& mesh, const BorderPair& ends);

struct Bridge {
  JoinProblem problem = JoinProblem::None;
  std::vector<Triangle> triangles;  // two; one where the points are two edges apart
};

// Two triangles over a border edge at each of the points, with the line between the points as one of their edges (He
// 2008, section 4.2): what they join stays manifold, the hole falls into two, or an island is tied to the rim. Of the
// ways to lay them the one whose triangles are best shaped and bend least against their neighbours. near: of this very
// mesh. The problem is that of the last way tried when none is free.
Bridge findBridge(const NearFaces& near, const BorderPair& ends);

}  // namespace handwheel
