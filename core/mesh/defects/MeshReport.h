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

// The statistics of a mesh as shown by "handwheel inspect". They are computed from the triangles after welding exactly
// equal positions, as any other program would read them from a file.
struct MeshReport : MeshState {
  std::size_t triangles = 0;
  std::size_t vertices = 0;
  std::vector<LoopReport> loops;
  std::size_t boundaryEdges = 0;
  std::size_t nonManifoldEdges = 0;
  std::size_t nonManifoldVertices = 0;
  std::size_t inconsistentEdges = 0;
  // Pieces connected across edges that cannot be oriented, as a Möbius strip. Their boundary loops are counted as they
  // run, although such a piece is cut where it is oriented.
  std::size_t oneSidedPieces = 0;
  long eulerCharacteristic = 0;  // vertices − edges + triangles
  double areaMm2 = 0.0;
  std::size_t insideOutBodies = 0;  // counted only if all edges are consistent
  // The numbers reversedFaces, nearVertices, debris and nestedBodies are counted only together with the
  // self-intersections.
  std::size_t reversedFaces = 0;  // faces oriented against most of their neighbours
  std::size_t nearVertices = 0;   // pairs of vertices that can be merged to close an open edge (stitchablePairs())
  std::size_t debris = 0;         // number of pieces of debris
  std::size_t nestedBodies = 0;   // bodies inside others (findNestedBodies())
  std::size_t degenerateFaces = 0;
  std::size_t duplicateFaces = 0;
  std::optional<double> volumeMm3;  // present only if the surface is closed and oriented
  Box box;
};

std::vector<LoopReport> reportOn(std::span<const BoundaryLoop> loops);

// The choice between skipping and counting self-intersections.
enum class SelfIntersections { Skip, Count };

// Computes the statistics of a triangle soup. O(n log n); the search for self-intersections takes most of the time. The
// result is incomplete if cancelled.
MeshReport reportOn(const TriangleSoup& soup, SelfIntersections choice, Progress progress = {});

}  // namespace handwheel
