// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/NearFaces.h"

#include <span>

namespace handwheel {

// Why faces cannot be joined to a mesh, or moved.
enum class JoinProblem {
  None,
  SamePoint,   // two corners are the same
  NoArea,      // a face would be degenerate
  EdgeFull,    // an edge would have more than two faces
  WrongWay,    // a neighbour runs the other way round
  CornerOnly,  // it would touch the surface in a point only
  Crosses,     // it would cross or touch another face
  TurnsOver,   // a face would be turned over
  NoBorder,    // nothing there is open
};

// Adds triangles over vertices that are there, and pairs their edges with each other and with the border half-edges at
// the same positions; where a border was pinched there, the fans that they join become one vertex. The new faces are
// the last. Nothing changes unless the result is JoinProblem::None: what results is manifold where it was, no edge has
// a third face, no new vertex is pinched, and no new face meets another in more than what they share. near: of this
// very mesh. O(faces near by) with a hierarchy.
JoinProblem addFaces(HalfEdgeMesh& mesh, std::span<const Triangle> triangles, const NearFaces& near);

}  // namespace handwheel
