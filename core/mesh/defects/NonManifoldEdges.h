// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <map>
#include <vector>

namespace handwheel {

// Non-manifold edges, with vertices identified by position. A file holds positions, not vertices: an edge is
// non-manifold if more than two faces have its two end positions.

// The fans of faces at one position, by vertex. Each fan is given by the half-edges that start at the vertex.
using Fans = std::map<Vertex, std::vector<HalfEdge>>;
// Finds the fans at the end positions of non-manifold edges. The keys are classes of positions (PointClasses). The
// result is incomplete if cancelled.
std::map<std::uint32_t, Fans> nonManifoldFans(const HalfEdgeMesh& mesh, Progress progress = {});

// Finds the fans at the positions of these vertices, for positions with several fans. The result has the same form as
// that of nonManifoldFans(). The result is incomplete if cancelled.
std::map<std::uint32_t, Fans> fansAt(const HalfEdgeMesh& mesh, const std::vector<Vertex>& vertices,
                                     Progress progress = {});

// Finds one half-edge of each surplus face pair at non-manifold edges. All pairs at an edge but the first are surplus.
std::vector<HalfEdge> surplusEdges(const HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
