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
  const std::set<PointKey>* kept = nullptr;  // a vertex of an open fan at one of these places is not moved
  Vertex firstNew = 0;                       // the vertices from this number on are moved rather than those before
};

// Moves vertices with equal positions apart where welding them would harm edges. A file holds positions, not fans:
// where several vertices share a position, writing welds them, and edges that are manifold in the mesh may have four
// faces in the file. The step is the smallest that the number type can represent and that makes no new
// self-intersection. Vertices whose welding harms no edge stay. An edge whose ends cannot be moved apart gets a vertex
// in its middle that can. Returns the vertices that were moved, then those that were added. spareCrossings: called only
// when some cannot be separated so; then so many self-intersections are made where that separates them. at: only what
// is at the positions of these vertices, there also what touches without harm to an edge; empty: wherever an edge is
// harmed.
std::vector<Vertex> separateCoincidentVertices(HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {},
                                               const std::function<std::size_t()>& spareCrossings = {},
                                               const std::vector<Vertex>& at = {}, const SeparationLimits& limits = {});

// Does the same wherever parts of the surface touch in a vertex without a common edge. The mesh is to be relinked.
std::vector<Vertex> separateTouchingVertices(HalfEdgeMesh& mesh, NumberType numbers, Progress progress = {},
                                             const SeparationLimits& limits = {});

}  // namespace handwheel
