// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/selection/FaceSelection.h"

namespace handwheel {

// Finds the peninsulas of a hole: border regions connected by a narrow neck. The neck is a path along edges of the
// surface between two points of the loop. It cuts a peninsula off when
//  - the loop is at least four times as long between the points as they are apart, measured the shorter way around;
//  - the path is no longer than 1.6 times the straight line, which starts into the surface at either end and not into
//    the hole;
//  - what is behind it has no more than three times the faces that n edges can surround: n²/π√3 equilateral ones, in a
//    flat disc.
// The narrowest necks are taken first, and what one cuts off is not examined again. The result is invalid if cancelled.
// O(n²) for n points, of which longer loops have a sample of 3,000.
FaceSelection findPeninsulas(const HalfEdgeMesh& mesh, const BoundaryLoop& hole, Progress progress = {});

}  // namespace handwheel
