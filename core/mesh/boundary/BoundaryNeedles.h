// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Tolerance.h"
#include "mesh/boundary/BoundaryLoops.h"

namespace handwheel {

// Finds the needles along boundary loops. A needle is a face with two open edges, one of them shorter than
// nearWeldReach() and than tolerance::kNearWeldEdge of the other. Without it the opening grows by less than that reach
// and no vertex moves. With it there is often no patch: the best ones double its third edge or intersect it. O(n).
std::vector<Face> findBoundaryNeedles(const HalfEdgeMesh& mesh, const std::vector<BoundaryLoop>& loops,
                                      double nearWeld = tolerance::kNearWeld);

}  // namespace handwheel
