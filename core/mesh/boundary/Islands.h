// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/selection/FaceSelection.h"

#include <span>
#include <vector>

namespace handwheel {

// Finds the islands of a hole: open surface pieces that lie inside it. A piece is an island if
//  - it is not connected by edges to the faces around the hole, and has fewer faces than their component;
//  - seen along the hole's mean normal, all of its vertices lie inside the hole's outline;
//  - no vertex is farther from the hole's mean plane than the farthest point of the hole by more than a quarter of the
//    hole's width. This tolerance allows for curved surfaces.
// A closed shell is not an island, but debris or a separate part; a sheet boundary has no islands. loops must contain
// all loops of the mesh. The result is invalid if cancelled. O(all loops + faces of the pieces in the hole).
FaceSelection findIslands(const HalfEdgeMesh& mesh, const BoundaryLoop& hole, std::span<const BoundaryLoop> loops,
                          Progress progress = {});

// Finds the outer boundary of each island of a hole: its longest loop. Otherwise like findIslands().
std::vector<const BoundaryLoop*> islandBoundaries(const HalfEdgeMesh& mesh, const BoundaryLoop& hole,
                                                  std::span<const BoundaryLoop> loops, Progress progress = {});

// Counts the islands of each loop. Nothing is counted if there are too many loops to compare all pairs of them.
void countIslands(const HalfEdgeMesh& mesh, std::span<BoundaryLoop> loops, Progress progress = {});

}  // namespace handwheel
