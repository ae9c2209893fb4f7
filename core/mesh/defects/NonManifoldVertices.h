// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <span>
#include <vector>

namespace handwheel {

// Finds the vertices whose triangles are not connected through their common edges. The result is ascending. Triangles
// with a repeated vertex are ignored. O(n). The result is invalid if cancelled.
std::vector<std::uint32_t> findNonManifoldVertices(std::span<const Triangle> triangles, std::size_t vertexCount,
                                                   Progress progress = {});

// Finds one vertex at each non-manifold position of a mesh as a file stores it. Returns an empty list if cancelled.
std::vector<Vertex> findNonManifoldVertices(const HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
