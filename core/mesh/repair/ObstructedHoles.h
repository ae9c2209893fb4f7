// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"
#include "mesh/holes/PatchStatistics.h"
#include "mesh/repair/SheetThickening.h"

#include <span>

namespace handwheel {

// A hole that no patch closes without intersecting or touching the part.
struct ObstructedHole {
  BoundaryLoop loop;
  bool back = false;  // true: close the hole by thickening its sheet instead of by a patch
};

// The result of closing one obstructed hole.
struct ObstructedClosing {
  bool closed = false;
  FillMethod method = FillMethod::Fair;
  Substitute substitute = Substitute::None;  // difference of the patch from the options
  std::size_t newFaces = 0;                  // number of new faces before any cuts
  PatchComparison shape = {};  // shape of the patch before any cuts; of several patches, the one that bends most
  bool isCutShort = false;     // true if not closed because a trial took too much effort or no effort was left
  FillFailure failure = FillFailure::SheetIntersecting;  // reason why a sheet to thicken is not closed
};

// The result of closeObstructedHoles().
struct ObstructedClosings {
  std::vector<ObstructedClosing> holes;  // one result per hole
  std::size_t cutFaces = 0;              // number of faces of the part that patches intersect
  SheetOutcomes sheets;                  // outcomes of the sheets to thicken
  std::vector<Vec3> separated;  // original positions of vertices that were moved because thin bodies would touch them
};

// Closes obstructed holes by patches that may intersect the part, or by thickening. Where a patch intersects the part,
// both are cut and the self-intersections removed (removeSelfIntersections()). Thickening a sheet (thickenSheets())
// closes every loop of the sheet, so a sheet is not thickened if one of its loops has a corner in
// FillOptions::keptCorners. A closing is kept only if it adds no self-intersections and leaves fewer edges without two
// faces; a thickening is kept only if it also adds no vertices at which faces touch without a common edge. All holes
// are tried together, then in halves, so that a failing hole does not affect the others. thickness: the thickness of
// thickened sheets, mm. The work is limited by the effort of the progress: each thickening may take half of the
// remaining effort and each trial a quarter. When the effort is spent, the remaining holes stay open, and the closings
// made so far are kept. A trial uses only the faces near its holes (Submesh), which are found in O(n). It uses the
// whole mesh if these faces are half of the mesh, or for thickening. O(n) for each closing that is kept.
ObstructedClosings closeObstructedHoles(HalfEdgeMesh& mesh, std::span<const ObstructedHole> holes,
                                        const FillOptions& options, double thickness, Progress progress = {});

}  // namespace handwheel
