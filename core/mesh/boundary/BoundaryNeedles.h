// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"

#include <span>

namespace handwheel {

// Finds the needles along boundary loops. A needle is a face with two open edges, one of them shorter than the reach
// (mm, from nearWeldReach()) and than tolerance::kNearWeldEdge times the other. Removing it widens the opening by less
// than the reach and moves no vertex. If a needle stays, patches often fail, because the best patches contain its third
// edge a second time or intersect it. O(edges of the loops).
std::vector<Face> findBoundaryNeedles(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, double reach);

}  // namespace handwheel
