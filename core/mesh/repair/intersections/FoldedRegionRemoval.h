// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"

#include <span>

namespace handwheel {

// Closes obstructed holes by removing the folded regions around them. Neither a patch nor a cut closes these loops
// (closeObstructedHoles()), because faces around them intersect or coincide. Those faces are removed, if necessary with
// rings of faces around them, and the opening is filled, as a user would do by hand. A change is kept only if it leaves
// no loop along the removed faces, fewer edges without two faces and no more self-intersections, and moves no point of
// the surface by more than tolerance::kFoldedRegionMove of the mesh's diagonal, or kFoldedRegionBodyMove for a body
// that is removed completely. Loops with FillOptions::keptCorners stay as they are. Returns the number of removed faces
// of the mesh. The work is limited by the effort of the progress. The cost of a trial is O(n) plus time in proportion
// to the faces near the loop. The mesh is invalid if the user cancelled.
std::size_t replaceFoldedRegions(HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, const FillOptions& options,
                                 Progress progress = {});

}  // namespace handwheel
