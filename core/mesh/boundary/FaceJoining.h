// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceLocator.h"

#include <span>

namespace handwheel {

// Reasons why faces cannot be added to a mesh or moved.
enum class JoinProblem {
  None,
  SamePoint,                // two corners are the same point
  DegenerateFace,           // a face would be degenerate
  NonManifoldEdge,          // an edge would have more than two faces
  InconsistentOrientation,  // a neighbour has the opposite orientation
  NonManifoldVertex,        // a face would touch the surface only at a point
  Crosses,                  // a face would intersect or touch another face
  FlippedFace,              // a face would be flipped
  NoBorder,                 // there is no open border or movable vertex
};

// Adds triangles over existing vertices to a mesh and joins their edges. Their edges are paired with each other and
// with the border half-edges at the same positions. If they join several fans of a pinched border vertex, these fans
// get one common vertex. The new faces get the last numbers. If the result is not JoinProblem::None, the mesh is
// unchanged. Otherwise the mesh is as manifold as before: no edge gets a third face, no new vertex is pinched, and no
// new face meets another outside of shared edges and vertices. near must be built from this mesh. O(nearby faces) if
// near has a hierarchy.
JoinProblem addFaces(HalfEdgeMesh& mesh, std::span<const Triangle> triangles, const FaceLocator& near);

}  // namespace handwheel
