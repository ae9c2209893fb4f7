// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"

#include <functional>
#include <span>
#include <vector>

namespace handwheel {

// The loops that joinIslands() may use.
struct IslandChoice {
  std::function<bool(const BoundaryLoop&)> isHole;    // true for holes that are to be filled
  std::function<bool(const BoundaryLoop&)> isIsland;  // false for outer boundaries of islands that must stay open
};

// Joins islands (findIslands()) to the holes in which they lie, so that one patch closes the hole around them. Each is
// connected by a bridge of two triangles (bridgeIsland()). This is done only if the patch of the common loop is
// possible; otherwise the hole stays as it is. loops must be all loops of the mesh; nothing is done for very many of
// them. Each hole with islands takes O(n), which counts as effort. Returns the outer boundaries of the joined islands,
// as indices of loops. The result is incomplete if cancelled.
std::vector<std::size_t> joinIslands(HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops,
                                     const IslandChoice& choice, const FillOptions& options, Progress progress = {});

}  // namespace handwheel
