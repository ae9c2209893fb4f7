// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/BoundaryLoops.h"
#include "mesh/NearFaces.h"

#include <vector>

namespace handwheel {

struct SmoothingOptions {
  double wavelength = 8.0;  // waves shorter than this many edges go, longer ones stay; below 2 only the spacing changes
  bool evenly = true;       // spread the points evenly along the curve
};

struct VertexMove {
  Vertex vertex = kNone;
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
};

struct SmoothedBorder {
  std::vector<VertexMove> moves;  // of the loop's vertices, those that move
  std::size_t held = 0;           // vertices that stay or stop short, lest a face turn over or something be torn apart
};

// Draws the vertices of a loop onto a smooth closed curve along it (PeriodicSpline.h). A plain spline through the
// points keeps every tooth of a ragged edge, so it is a smoothing one: it takes waves by their length, and leaves the
// loop's size and place, where averaging neighbours would shrink it. A small loop keeps its shape: waves of a third of
// it or longer stay. Where a border face would turn over, lose its area or cross another, its corners go less far;
// points that other fans or seams share stay. near: of this very mesh. O(n log n).
SmoothedBorder smoothBorder(const NearFaces& near, const BoundaryLoop& loop, const SmoothingOptions& options = {});

// Makes moves, if every vertex is where it was. False, and nothing changed, when one is not.
bool moveVertices(HalfEdgeMesh& mesh, const std::vector<VertexMove>& moves);

}  // namespace handwheel
