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

// Closes a welded soup by cones from its boundaries. A boundary consists of connected edges that occur more often in
// one direction than in the other; where it passes a vertex several times it is divided there, and each loop gets a
// cone to its own centre, or a triangle if it has three edges. The cones add the missing occurrences. So every edge of
// the result occurs equally often in both directions, whether the soup had holes, gaps or flipped faces, and winding
// numbers are integers. O(n log n). The soup is unchanged if cancelled.
//
// A loop is wide if it extends over more than wideFrom and most of its edges have one face. So are the outlines of
// patches of any size, if most of the surface is such patches: open shells whose cones have nearly their area, as in a
// surface that is cracked all over. The tips of the cones
// over wide boundaries are slightly off the centre, so that no cone lies in a plane of a grid with spacing 1. A
// loop is flat if its cone has no fold and all its points are within a quarter of that spacing from one plane.
BoundaryCaps closeBoundaries(TriangleSoup& welded, double wideFrom, Progress progress = {});

}  // namespace handwheel
