// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/HoleContext.h"
#include "mesh/Patch.h"

#include <optional>
#include <utility>
#include <vector>

namespace handwheel {

enum class Criterion {
  Area,      // the least area (Barequet and Sharir, "Filling gaps in the boundary of a polyhedron", 1995)
  Dihedral,  // the least largest angle between neighbours, those around the hole included; then the least area
             // (Liepa, "Filling holes in meshes", 2003)
};

// The triangulation of the loop's points alone that is best by the criterion, found by dynamic programming over all of
// them; where many are equal, as in flat holes, one with short diagonals. The best by Dihedral is that of Liepa's
// programme, which settles each part before it sees what lies beyond. Triangles without area and edges among the taken
// ones (sorted pairs of loop points, as Obstacles::edgesAmong() gives) are left out. None beyond
// tolerance::kOptimalFillEdges, when there is none, and once cancelled. O(n³) time, O(n²) memory: about 20 ms for 300
// edges. Looks at the cancel flag n times.
std::optional<Patch> triangulateOptimal(const HoleContext& hole, Criterion criterion,
                                        const std::vector<std::pair<std::uint32_t, std::uint32_t>>& taken = {},
                                        Progress progress = {});

}  // namespace handwheel
