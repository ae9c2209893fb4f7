// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"

#include <vector>

namespace handwheel {

struct BoundaryCaps {
  std::size_t boundaries = 0;
  std::vector<std::uint32_t> wide;  // the triangles of cones over holes that are wide and not flat
};

// Closes a welded soup: appends a cone from each boundary to the middle of it. A boundary are edges that are passed in
// one direction more often than in the other, joined where they share a point; each is passed back as often as needed.
// So every edge is then passed equally often both ways, whatever the soup was: holes, gaps and faces that are turned
// round, too, and winding numbers are whole. O(n log n). The soup is as it was when cancelled.
//
// Wide are boundaries that extend over more than wideFrom and are holes for the most part: their edges have one face.
// The tips of their cones are a little beside the middle, so that no cone lies in a plane of a grid of edge 1. Flat are
// those whose cones stay within a quarter of such a grid of a plane, without a fold.
BoundaryCaps closeBoundaries(TriangleSoup& welded, double wideFrom, Progress progress = {});

}  // namespace handwheel
