// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HoleFilling.h"

#include <set>

namespace handwheel {

// What to do with the outer edges of open sheets.
enum class RimHandling {
  Keep,
  Back,  // the sheet becomes a thin body (backSheet()), unless it is the picture of a body from one side
  Fill,  // as if they were holes
};

struct RepairOptions {
  FillOptions fill;
  double nearWeld = tolerance::kNearWeld;  // share of the diagonal; the setting mesh.near_weld
  std::set<int> keepOpen;                  // loop ids, as in findBoundaryLoops() of the input
  RimHandling rims = RimHandling::Back;
  std::size_t maxEdges = 0;  // loops with more edges stay open; 0: no limit
  bool removeDebris = false;
  bool takeOutTangles = true;  // where nothing else closes a hole (replaceTangles())
  bool cutCrossings = false;   // apart, where the surface passes through itself (uncrossClusters())
};

enum class LoopOutcome { Filled, KeptOpen, Failed };  // from best to worst

struct LoopResult {
  int id = -1;  // as in findBoundaryLoops() of the input; -1 for a hole that the repair itself laid open
  std::size_t edges = 0;
  LoopOutcome outcome = LoopOutcome::Failed;
  FillMethod method = FillMethod::Fair;    // when filled
  FillFailure reason = FillFailure::None;  // when not filled
  std::size_t newFaces = 0;                // of its patches; one patch over several loops counts for each
  double milliseconds = 0.0;
};

struct RepairReport {
  std::vector<LoopResult> loops;      // every loop of the input, by id; then those laid open
  std::vector<int> lostLoops;         // of keepOpen: gone with faces that were removed or brought together
  std::size_t removedDegenerate = 0;  // faces
  std::size_t removedDuplicates = 0;
  std::size_t removedFlaps = 0;
  std::size_t removedDebris = 0;
  std::size_t turnedFaces = 0;
  std::size_t mergedVertices = 0;
  std::size_t oneSidedCuts = 0;         // along short ways, where the surface had one side only
  std::size_t cutFaces = 0;             // where a patch crosses the part
  std::size_t cutClusters = 0;          // places where the surface passed through itself
  std::size_t replacedFaces = 0;        // taken out where they were tangled around a hole, and filled anew
  std::size_t partedVertices = 0;       // moved, or put into the middle of an edge, so that nothing welds that must not
  std::vector<Vertex> touchedVertices;  // of the input: moved, merged or parted
  std::size_t effort = 0;               // steps of Effort; at most twice repairEffort() of the input's faces
  bool cancelled = false;
};

// Makes the mesh closed, manifold and free of new self-intersections as far as that can be done without harm and with
// an effort in proportion to n log n; what stays open is in the report with its reason. On cancel the mesh is left as
// it was.
RepairReport repair(HalfEdgeMesh& mesh, const RepairOptions& options, Progress progress = {});

}  // namespace handwheel
