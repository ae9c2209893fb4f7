// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <span>
#include <vector>

namespace handwheel {

// A vertex and its target position. The vertex is given by a half-edge that starts at it; from this half-edge its faces
// are found.
struct VertexGoal {
  HalfEdge leaving;
  Vec3 to;  // mm
};

// The result of moveTowards().
struct MovedVertices {
  std::vector<Face> faces;   // faces around the vertices with goals, ascending
  std::size_t heldBack = 0;  // vertices that did not reach their goal
};

// Moves vertices towards their goals, as far as no face becomes invalid. No face flips, loses its area or becomes a
// needle. If a face would, its vertices move half of the distance, then a quarter and so on, and finally stay.
// Positions are rounded to the number type of the file. A vertex whose goal is not finite or equals its position stays,
// bit for bit. Each vertex must occur only once. Nothing moves if cancelled. O(faces around the vertices) plus one bit
// of memory for each face slot.
MovedVertices moveTowards(HalfEdgeMesh& mesh, std::span<const VertexGoal> moves,
                          NumberType numbers = NumberType::Float64, Progress progress = {});

}  // namespace handwheel
