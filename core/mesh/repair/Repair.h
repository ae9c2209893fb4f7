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

// How the outer edges of open sheets are treated.
enum class SheetHandling {
  Keep,     // those of the input, and those that the repair itself makes
  Thicken,  // the sheet becomes a thin body (thickenSheets())
  Fill,     // as if they were holes
};

// Options of repair().
struct RepairOptions {
  FillOptions fill;
  double nearWeld = tolerance::kNearWeld;  // share of the diagonal; the setting mesh.near_weld
  std::set<int> keepOpen;                  // loop ids, as in findBoundaryLoops() of the input
  SheetHandling sheets = SheetHandling::Keep;
  double thickness = 0.0;    // of thickened sheets, mm, less where they bend more; 0: defaultSheetThickness()
  std::size_t maxEdges = 0;  // loops with more edges stay open; 0: no limit
  bool removeDebris = false;
  bool replaceFoldedRegions = true;  // where nothing else closes a hole (replaceFoldedRegions())
  bool cutCrossings = false;         // remove self-intersections of the surface (removeClusterIntersections())
  bool uniteSolids = false;          // before that: unite solids that intersect (uniteSolids())

  bool resolvesIntersections() const { return cutCrossings || uniteSolids; }
};

// The outcomes of a repair for a boundary loop, from best to worst.
enum class LoopOutcome { Filled, KeptOpen, Failed };

// The result of a repair for one boundary loop.
struct LoopResult {
  int id = -1;  // as in findBoundaryLoops() of the input; -1 for a hole that the repair itself opened
  std::size_t edges = 0;
  bool isSheetBoundary = false;  // of the input: the outer edge of an open sheet
  LoopOutcome outcome = LoopOutcome::Failed;
  FillMethod method = FillMethod::Fair;    // when filled
  FillFailure reason = FillFailure::None;  // when not filled
  std::size_t newFaces = 0;                // of its patches; one patch over several loops counts for each
  double milliseconds = 0.0;
  PatchComparison shape = {};  // of a patch; not known without one
};

// A boundary loop that a repair leaves, with its own reason: a loop of the input may be left in pieces.
struct OpenLoop {
  Vertex key = kNone;                           // keyOf() in the result
  LoopOutcome outcome = LoopOutcome::KeptOpen;  // or Failed
  FillFailure reason = FillFailure::None;
};

// The report of a repair.
struct RepairReport {
  std::vector<LoopResult> loops;      // every loop of the input, by id; then those that the repair opened
  std::vector<OpenLoop> openLoops;    // every loop of the result
  std::vector<int> lostLoops;         // of keepOpen: gone with faces that were removed or stitched
  std::size_t removedDegenerate = 0;  // faces without area, and needles along holes
  std::size_t removedDuplicates = 0;
  std::size_t removedFlaps = 0;
  std::size_t removedDebris = 0;  // and of small closed pieces that the repair itself cut off
  std::size_t reversedFaces = 0;
  std::size_t reversedBodies = 0;  // that were inside out; of the same faces
  std::size_t mergedVertices = 0;
  std::size_t nonOrientableCuts = 0;             // along short cycles, where the surface was non-orientable
  std::size_t cutFaces = 0;                      // where a patch intersects the part
  std::size_t cutClusters = 0;                   // clusters of self-intersections that were removed
  std::size_t innerFaces = 0;                    // of united solids, pieces of walls inside of them that were removed
  std::size_t replacedFaces = 0;                 // removed from folded regions around holes, which were refilled
  std::size_t separatedVertices = 0;             // moved, or inserted in the middle of an edge, against wrong welding
  SheetOutcomes sheets;                          // that were to be thickened
  std::vector<Vertex> modifiedVertices;          // of the input: moved, merged or separated
  std::optional<FarthestRemovedVertex> removed;  // from the outside of the input (farthestRemovedVertex())
  bool isSeparationIncomplete = false;           // by the effort: more vertices may coincide than must
  bool isIntersectionRemovalIncomplete = false;  // by the effort: more may intersect than must
  std::size_t effort = 0;                        // steps of Effort; at most twice repairBudget() of the input's faces
  std::size_t countedEffort = 0;  // the same, and what was done beyond before it was looked at (Effort::counted())
  bool cancelled = false;
};

// Repairs a mesh so that it is closed and manifold, without new self-intersections. This is done as far as it does no
// harm, and with an effort in proportion to n log n; what stays open is in the report with its reason. If cancelled,
// the mesh is unchanged.
RepairReport repair(HalfEdgeMesh& mesh, const RepairOptions& options, Progress progress = {});

}  // namespace handwheel
