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
  bool back = false;  // close it by thickening its sheet instead of a patch
};

// The result of closing one obstructed hole.
struct ObstructedClosing {
  bool closed = false;
  FillMethod method = FillMethod::Fair;
  std::size_t newFaces = 0;    // number before any cuts
  PatchComparison shape = {};  // shape of its patch before any cuts; the one that bends most if there are several
  bool isCutShort = false;     // not closed because a trial took too much effort or none was left for it
  FillFailure failure = FillFailure::SheetIntersecting;  // for a sheet that should be thickened and is not closed
};

// The result of closeObstructedHoles().
struct ObstructedClosings {
  std::vector<ObstructedClosing> holes;  // one per hole
  std::size_t cutFaces = 0;              // faces of the part that patches intersect
  SheetOutcomes sheets;                  // outcomes of the sheets to thicken
  std::vector<Vec3> separated;  // original positions of vertices that were moved because thin bodies would touch them
};

// Closes obstructed holes by patches that may intersect the part, or by thickening. Where a patch intersects the part,
// both are cut and the self-intersections removed (removeSelfIntersections()). Thickening a sheet (thickenSheets())
// closes every loop of the sheet, so it is not done if one has FillOptions::keptCorners. A closing is kept only if it
// adds no self-intersections and leaves fewer edges without two faces; a thickening, only if it also adds no vertices
// at which faces touch without a common edge. All are tried together, then by halves, so that a failing one affects
// only itself. thickness is that of thickened sheets, mm. The work is limited by the effort of the progress: each
// thickening may take half of the remaining effort and each trial a quarter. The holes still open then stay so, and the
// mesh is as the last closing left it. A trial uses the faces near its holes (Submesh), found in O(n), or the whole
// mesh if these are half of it or for thickening. O(n) for each closing that is kept.
ObstructedClosings closeObstructedHoles(HalfEdgeMesh& mesh, std::span<const ObstructedHole> holes,
                                        const FillOptions& options, double thickness, Progress progress = {});

}  // namespace handwheel
