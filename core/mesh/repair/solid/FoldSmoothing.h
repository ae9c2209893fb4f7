// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// The result of smoothFolds().
struct SmoothedFolds {
  std::vector<Vertex> moved;
  double noise = 0.0;     // mm, the noise that was measured at the folds; no vertex moved farther than three times it
  double farthest = 0.0;  // mm, the longest displacement of a vertex
};

// Smooths a noisy surface where it folds: around faces that intersect others next to them. The vertices there move
// towards the middle of their neighbours, but never farther than three times the noise, which is the usual distance of
// these vertices from the middle of their neighbours. Faces that intersect others elsewhere on the surface stay.
// Nothing moves if there is no such fold. If cancelled, the mesh is unchanged. O(n log n) for each of a few rounds.
SmoothedFolds smoothFolds(HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {});

}  // namespace handwheel
