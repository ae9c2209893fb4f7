// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/selection/FaceSelection.h"

namespace handwheel {

// Finds the peninsulas of a hole: border regions connected by a narrow neck. The neck is a path along edges of the
// surface between two points of the loop. It cuts off a peninsula if
//  - the shorter part of the loop between the points is at least four times as long as their distance;
//  - the path is at most 1.6 times as long as the straight line between the points, and at both points this line starts
//    towards the surface, not into the hole;
//  - the region that it cuts off has at most three times as many faces as a flat disc of equilateral faces with the
//    same number n of edges around it, which has n²/(π√3) faces.
// The narrowest necks are processed first, and a region that was cut off is not examined again. The result is invalid
// if cancelled. O(n²) for n loop points; loops with more than 3,000 points are sampled at 3,000 of them.
FaceSelection findPeninsulas(const HalfEdgeMesh& mesh, const BoundaryLoop& hole, Progress progress = {});

}  // namespace handwheel
