// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceLocator.h"

#include <span>

namespace handwheel {

// Reasons why faces cannot be added to a mesh, or moved.
enum class JoinProblem {
  None,
  SamePoint,                // two corners are the same
  DegenerateFace,           // a face would be degenerate
  NonManifoldEdge,          // an edge would have more than two faces
  InconsistentOrientation,  // a neighbour has the opposite orientation
  NonManifoldVertex,        // it would touch the surface in a point only
  Crosses,                  // it would intersect or touch another face
  FlippedFace,              // a face would be flipped
  NoBorder,                 // there is no open border
};

// Adds triangles over existing vertices to a mesh and joins their edges. Edges are paired with each other and with the
// border half-edges at the same positions; where a border was pinched there, the fans that they join become one vertex.
// The new faces get the last numbers. Nothing changes unless the result is JoinProblem::None: then the mesh is as
// manifold as before, no edge has a third face, no new vertex is pinched, and no new face meets another outside of
// shared edges and vertices. near must be built from this mesh. O(nearby faces) with a hierarchy.
JoinProblem addFaces(HalfEdgeMesh& mesh, std::span<const Triangle> triangles, const FaceLocator& near);

}  // namespace handwheel
