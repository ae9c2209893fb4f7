// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/PositionKey.h"

#include <functional>
#include <vector>

namespace handwheel {

// Limits on the vertices that separateCoincidentVertices() moves.
struct SeparationLimits {
  const std::set<PointKey>* kept = nullptr;  // a vertex of an open fan at one of these positions is not moved
  Vertex firstNew = 0;                       // vertices from this number on are moved in preference to earlier ones
};

// Moves vertices with equal positions apart where welding them would make edges non-manifold. A file holds positions,
// not fans: if several vertices share a position, writing welds them, and edges that are manifold in the mesh may have
// four faces in the file. The step is the smallest that the number type can represent and that makes no new
// self-intersection. Vertices whose welding harms no edge stay. An edge whose ends cannot be moved apart gets a movable
// vertex in its middle. Returns the vertices that were moved, then those that were added. spareCrossings is called only
// if some vertices cannot be separated without new self-intersections; it must return the number of self-intersections
// that may be made to separate them. If "at" is not empty, the separation is restricted to the positions of its
// vertices, where vertices that merely touch are separated too. Otherwise, all positions with harmed edges are treated.
std::vector<Vertex> separateCoincidentVertices(HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {},
                                               const std::function<std::size_t()>& spareCrossings = {},
                                               const std::vector<Vertex>& at = {}, const SeparationLimits& limits = {});

// Separates the vertices at which parts of the surface touch without a common edge. Returns the moved and the added
// vertices, like separateCoincidentVertices(). The caller must relink the mesh.
std::vector<Vertex> separateTouchingVertices(HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {},
                                             const SeparationLimits& limits = {});

}  // namespace handwheel
