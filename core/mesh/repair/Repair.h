// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"
#include "mesh/holes/PatchStatistics.h"
#include "mesh/repair/FarthestRemovedVertex.h"
#include "mesh/repair/SheetThickening.h"

#include <optional>
#include <set>

namespace handwheel {

// The treatment of the outer edges of open sheets.
enum class SheetHandling {
  Keep,     // the edges stay open, including those that the repair itself makes
  Thicken,  // the edges are closed by making the sheet a thin body (thickenSheets())
  Fill,     // the edges are filled like holes
};

// The shape that a part shall get.
enum class RepairGoal {
  Certain,  // only what is certain is repaired, as the other options say
  Surface,  // one layer without cracks and crumbs, whose outer boundaries stay open
  Solid,    // the same, closed: it can be printed
};

// Options of repair(). A goal that is not Certain includes the other options that it needs.
struct RepairOptions {
  FillOptions fill;
  double nearWeld = tolerance::kNearWeld;  // fraction of the diagonal; the setting mesh.near_weld
  std::set<int> keepOpen;                  // loop ids from findBoundaryLoops() of the input
  SheetHandling sheets = SheetHandling::Keep;
  // Thickness of thickened sheets, mm; 0: defaultSheetThickness(). Sheets become thinner where they bend strongly.
  double thickness = 0.0;
  std::size_t maxEdges = 0;  // loops with more edges stay open; 0: no limit
  bool removeDebris = false;
  bool replaceFoldedRegions = true;  // last resort to close a hole (replaceFoldedRegions())
  bool cutCrossings = false;         // remove self-intersections of the surface (removeClusterIntersections())
  bool uniteSolids = false;          // unite intersecting solids before self-intersections are removed
  RepairGoal goal = RepairGoal::Certain;

  bool resolvesIntersections() const { return cutCrossings || uniteSolids; }
};

// The outcomes of a repair for a boundary loop, from best to worst.
enum class LoopOutcome { Filled, KeptOpen, Failed };

// The result of a repair for one boundary loop.
struct LoopResult {
  int id = -1;  // id from findBoundaryLoops() of the input; -1 for a hole that the repair itself opened
  std::size_t edges = 0;
  bool isSheetBoundary = false;  // outer edge of an open sheet in the input
  LoopOutcome outcome = LoopOutcome::Failed;
  FillMethod method = FillMethod::Fair;      // method if filled
  Substitute substitute = Substitute::None;  // difference of the patch from the options
  FillFailure reason = FillFailure::None;    // reason if not filled
  std::size_t newFaces = 0;                  // faces of its patches; a patch over several loops counts for each loop
  double milliseconds = 0.0;
  PatchComparison shape = {};  // shape of its patch; unknown without a patch
};

// A boundary loop that a repair leaves open, with its reason. A loop of the input may be left in several pieces.
struct OpenLoop {
  Vertex key = kNone;                           // keyOf() of the loop in the result
  LoopOutcome outcome = LoopOutcome::KeptOpen;  // KeptOpen or Failed
  FillFailure reason = FillFailure::None;
};

// The report of a repair.
struct RepairReport {
  std::vector<LoopResult> loops;      // every loop of the input, by id; then those that the repair opened
  std::vector<OpenLoop> openLoops;    // every loop of the result
  std::vector<int> lostLoops;         // loops of keepOpen that vanished with removed or stitched faces
  std::size_t removedDegenerate = 0;  // faces without area, and needles along holes
  std::size_t removedDuplicates = 0;
  std::size_t removedFlaps = 0;
  std::size_t removedDebris = 0;     // faces of debris, and of small closed pieces that the repair itself cut off
  std::size_t removedLayers = 0;     // faces of second layers of a scan
  std::size_t stitchedCracks = 0;    // vertices that were moved to stitch cracks
  std::size_t smoothedVertices = 0;  // vertices that were moved where noise folded the surface
  double measuredNoise = 0.0;        // mm, there; no vertex was smoothed by more than three times it
  std::size_t reversedFaces = 0;
  std::size_t reversedBodies = 0;  // reversed inside-out bodies; their faces are in reversedFaces
  std::size_t mergedVertices = 0;
  std::size_t nonOrientableCuts = 0;  // cuts along short cycles of non-orientable surfaces
  std::size_t cutFaces = 0;           // faces cut where a patch intersects the part
  std::size_t cutClusters = 0;        // clusters of self-intersections that were removed
  std::size_t innerFaces = 0;         // removed pieces of walls inside united solids
  std::size_t replacedFaces = 0;      // faces removed from folded regions around holes, which were refilled
  std::size_t separatedVertices = 0;  // vertices moved, or inserted in the middle of an edge, to prevent wrong welding
  SheetOutcomes sheets;               // outcomes of the sheets to thicken
  std::vector<Vertex> modifiedVertices;  // vertices of the input that were moved, merged or separated
  // Farthest vertex removed from the outside of the input (farthestRemovedVertex()).
  std::optional<FarthestRemovedVertex> removed;
  bool isSeparationIncomplete = false;  // the effort was exhausted, so more vertices may coincide than necessary
  bool isIntersectionRemovalIncomplete = false;  // the effort was exhausted, so more faces may intersect than necessary
  std::size_t effort = 0;         // steps of WorkBudget; at most twice repairBudget() of the input's faces
  std::size_t countedEffort = 0;  // effort, with steps that exceeded a limit unnoticed (WorkBudget::counted())
  bool cancelled = false;
};

// Repairs a mesh so that it is closed and manifold, without new self-intersections. Harmful changes are avoided, and
// the effort is proportional to n log n; the report lists each loop that stays open with its reason. If cancelled, the
// mesh is unchanged.
RepairReport repair(HalfEdgeMesh& mesh, const RepairOptions& options, Progress progress = {});

}  // namespace handwheel
