// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/search/FaceLocator.h"

#include <vector>

namespace handwheel {

// Options of smoothBoundary().
struct SmoothingOptions {
  static constexpr double kLongestWavelength = 100.0;

  // Number of edges of a wave. Shorter waves are removed, longer waves stay; below 2, only the spacing changes.
  double wavelength = 8.0;
  bool evenly = true;                        // spread the points evenly along the curve
  NumberType numbers = NumberType::Float64;  // number type of the file; new positions are representable in it
};

// A vertex with its old and new position.
struct VertexMove {
  Vertex vertex = kNone;
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
};

// The moves that smooth a boundary loop.
struct SmoothedBoundary {
  std::vector<VertexMove> moves;  // one per loop vertex that moves
  std::size_t held = 0;           // number of vertices held back so that no face flips and nothing is torn apart
};

// Smooths a boundary loop by moving its vertices onto a closed smoothing spline (PeriodicSpline.h). An interpolating
// spline keeps every tooth of a ragged edge; the smoothing one filters waves by their length, and preserves the loop's
// size and position, whereas averaging neighbours would shrink it. A small loop keeps its shape: waves longer than a
// third of it stay. Where a boundary face would flip, lose its area or intersect another, its corners move less; points
// that other fans or seams share stay. near must be built from the mesh of the loop. O(n log n).
SmoothedBoundary smoothBoundary(const FaceLocator& near, const BoundaryLoop& loop,
                                const SmoothingOptions& options = {});

// Applies vertex moves if every vertex is at its old position. Otherwise returns false and changes nothing.
bool moveVertices(HalfEdgeMesh& mesh, const std::vector<VertexMove>& moves);

}  // namespace handwheel
