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
  bool back = false;  // by thickening its sheet rather than by a patch
};

// The result of closing one obstructed hole.
struct ObstructedClosing {
  bool closed = false;
  FillMethod method = FillMethod::Fair;
  std::size_t newFaces = 0;    // before anything was cut
  PatchComparison shape = {};  // of its patch before anything was cut, of several that which bends most
  bool isCutShort = false;     // not closed; a trial of it took too much effort, or there was none left for one
  FillFailure failure = FillFailure::SheetIntersecting;  // of a sheet that was to be thickened and is not closed
};

// The result of closeObstructedHoles().
struct ObstructedClosings {
  std::vector<ObstructedClosing> holes;  // one for each
  std::size_t cutFaces = 0;              // of the part, where patches intersect it
  SheetOutcomes sheets;                  // of those that were to be thickened
  std::vector<Vec3> separated;           // where vertices were that thin bodies would touch, before they were moved
};

// Closes obstructed holes by patches that may intersect the part, or by thickening. Where a patch intersects the part,
// both are cut and the self-intersections removed (removeSelfIntersections()). Thickening a sheet (thickenSheets())
// closes every loop of the sheet, so it is not done where one has FillOptions::keptCorners. A closing is kept only if
// it leaves no more self-intersections than there were, and fewer edges without two faces; a thickening, if it also
// leaves no more vertices at which faces touch without a common edge. All are tried together, then
// by halves, so that a bad one costs its own closing only. thickness: of thickened sheets, mm. Takes no more than the
// effort of the progress, each thickening half of what is left of it and each trial a quarter: what is still open then
// stays so, and the mesh is as the last closing left it. A trial takes the faces near its holes (Submesh), and O(n) to
// find them; all of the mesh where these are half of it, or with thickening. O(n) for each that is kept.
ObstructedClosings closeObstructedHoles(HalfEdgeMesh& mesh, std::span<const ObstructedHole> holes,
                                        const FillOptions& options, double thickness, Progress progress = {});

}  // namespace handwheel
