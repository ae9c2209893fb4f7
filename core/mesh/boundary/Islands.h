// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/selection/FaceSelection.h"

#include <span>

namespace handwheel {

// Finds the islands of a hole: open surface pieces that lie inside it. A piece is one when
//  - it is not connected by edges to the faces around the hole, and has fewer faces than these and what is connected to
//    them;
//  - seen along the hole's mean normal, all of its vertices lie inside the hole's outline;
//  - none is further from the hole's mean plane than the hole's own points are, by more than a quarter of the hole's
//    width: on a curved surface it bulges so far.
// A closed shell is no island, but debris or a separate part; a sheet boundary surrounds its sheet and has none. loops:
// those of the mesh. The result is invalid if cancelled. O(all loops + faces of what lies in the hole).
FaceSelection findIslands(const HalfEdgeMesh& mesh, const BoundaryLoop& hole, std::span<const BoundaryLoop> loops,
                          Progress progress = {});

// Counts the islands of each loop. Nothing is counted where there are too many loops to compare each with each.
void countIslands(const HalfEdgeMesh& mesh, std::span<BoundaryLoop> loops, Progress progress = {});

}  // namespace handwheel
