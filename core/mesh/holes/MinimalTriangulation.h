// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/holes/HoleContext.h"
#include "mesh/holes/Patch.h"

#include <optional>
#include <utility>
#include <vector>

namespace handwheel {

// The criteria of an optimal triangulation.
enum class Criterion {
  Area,      // the least area (Barequet and Sharir, "Filling gaps in the boundary of a polyhedron", 1995)
  Dihedral,  // the smallest maximum angle between neighbours, including those around the hole; then the least area
             // (Liepa, "Filling holes in meshes", 2003)
};

// Computes the optimal triangulation of a loop's points by dynamic programming. All triangulations without added points
// are considered; if several are equal, as in flat holes, one with short diagonals is chosen. The optimum by Dihedral
// is that of Liepa's algorithm, which decides each part independently of its surroundings. Triangles without area and
// the edges in "taken" (sorted pairs of loop points from Obstacles::edgesAmong()) are excluded. Returns nothing if the
// loop has more than tolerance::kOptimalFillEdges edges, if no triangulation exists, or if cancelled. O(n³) time, O(n²)
// memory: about 20 ms for 300 edges. The cancel flag is polled n times.
std::optional<Patch> triangulateOptimal(const HoleContext& hole, Criterion criterion,
                                        const std::vector<std::pair<std::uint32_t, std::uint32_t>>& taken = {},
                                        Progress progress = {});

}  // namespace handwheel
