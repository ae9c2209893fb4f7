// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"

#include <span>

namespace handwheel {

// Closes obstructed holes by removing the folded regions around them. These are loops that neither a patch nor a cut
// closes (closeObstructedHoles()), because faces around them intersect or lie on each other: those faces are removed,
// where that is not enough with rings of faces around them, and the opening is filled, as one would by hand. A change
// is kept only if it leaves fewer edges without two faces, no more self-intersections and no loop, moves no point of
// the surface by more than tolerance::kFoldedRegionMove of the mesh's diagonal, and of a body that is removed as a
// whole by kFoldedRegionBodyMove. Loops with FillOptions::keptCorners stay as they are. Returns the number of removed
// faces of the mesh. Takes no more than the effort of the progress. O(n) for each trial, the rest in proportion to the
// faces near the loop. The mesh is invalid if the user cancelled.
std::size_t replaceFoldedRegions(HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, const FillOptions& options,
                                 Progress progress = {});

}  // namespace handwheel
