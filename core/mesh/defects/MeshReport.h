// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/defects/MeshState.h"

#include <optional>
#include <span>
#include <vector>

namespace handwheel {

// The properties of one boundary loop.
struct LoopReport {
  int id = 0;
  std::size_t edges = 0;
  double lengthMm = 0.0;
  double planarity = 0.0;
  double areaMm2 = 0.0;
  std::size_t islands = 0;
  bool isSheetBoundary = false;  // the outer edge of an open sheet
};

// The statistics of a mesh as shown by "handwheel inspect". Computed from the triangles after welding exactly equal
// positions: what any other program would see in a file that holds them.
struct MeshReport : MeshState {
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  std::vector<LoopReport> loops;
  std::size_t boundaryEdges = 0;
  std::size_t nonManifoldEdges = 0;
  std::size_t nonManifoldVertices = 0;
  std::size_t inconsistentEdges = 0;
  std::size_t insideOutBodies = 0;  // counted where all edges are consistent
  // Counted with the self-intersections only.
  std::size_t reversedFaces = 0;  // that face the other way than most of their neighbours
  std::size_t nearVertices = 0;   // pairs that could close an open edge (stitchablePairs())
  std::size_t debris = 0;         // pieces
  std::size_t nestedBodies = 0;   // bodies inside others (findNestedBodies())
  std::size_t degenerateFaces = 0;
  std::size_t duplicateFaces = 0;
  std::optional<double> volumeMm3;  // only when closed
  Box box;
};

std::vector<LoopReport> reportOn(std::span<const BoundaryLoop> loops);

// Whether self-intersections are counted.
enum class SelfIntersections { Skip, Count };

// Computes the statistics of a triangle soup. O(n log n); self-intersections cost most of it. Incomplete if cancelled.
MeshReport reportOn(const TriangleSoup& soup, SelfIntersections choice, Progress progress = {});

}  // namespace handwheel
