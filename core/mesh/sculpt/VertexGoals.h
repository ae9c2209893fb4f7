// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <span>
#include <vector>

namespace handwheel {

// A vertex and its target position. It is named by a half-edge that leaves it, from which its faces are found.
struct VertexGoal {
  HalfEdge leaving;
  Vec3 to;  // mm
};

// The result of moveTowards().
struct MovedVertices {
  std::vector<Face> faces;   // around the vertices that were to move, in rising order
  std::size_t heldBack = 0;  // vertices that did not reach their goal
};

// Moves vertices towards their goals, as far as no face becomes invalid. No face flips, loses its area or becomes a
// needle by it: the vertices of a face that would go half of the way, then half of that, at last nowhere. Positions are
// rounded to the numbers of the file. A vertex whose goal is not finite or equals its position stays, bit for bit. Each
// vertex is named once. Nothing moves when cancelled. O(faces around them), and a bit for each face slot.
MovedVertices moveTowards(HalfEdgeMesh& mesh, std::span<const VertexGoal> moves,
                          NumberType numbers = NumberType::Float64, Progress progress = {});

}  // namespace handwheel
