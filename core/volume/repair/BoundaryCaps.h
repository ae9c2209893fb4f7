// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/TriangleSoup.h"

#include <vector>

namespace handwheel {

struct BoundaryCaps {
  std::size_t boundaries = 0;
  std::vector<std::uint32_t> wide;  // triangles of the cones of boundaries that are wide and not flat
};

// Closes a welded soup by a cone from each boundary to its centre. A boundary consists of connected edges that occur
// more often in one direction than in the other; its cone adds the missing occurrences. So every edge of the result
// occurs equally often in both directions, whether the soup had holes, gaps or flipped faces, and winding numbers are
// integers. O(n log n). The soup is unchanged if cancelled.
//
// A boundary is wide if it extends over more than wideFrom and most of its edges have one face. The tips of the cones
// over wide boundaries are slightly off the centre, so that no cone lies in a plane of a grid with spacing 1. A
// boundary is flat if its cone has no fold and all its points are within a quarter of that spacing from one plane.
BoundaryCaps closeBoundaries(TriangleSoup& welded, double wideFrom, Progress progress = {});

}  // namespace handwheel
