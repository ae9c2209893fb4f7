// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Tolerance.h"
#include "mesh/holes/Fairing.h"
#include "mesh/holes/HoleContext.h"
#include "mesh/holes/Patch.h"

#include <optional>

namespace handwheel {

// Triangulates a hole with CGAL, by dihedral angle and area. First with the edges of the Delaunay tetrahedrisation,
// O(n log n) (Zou et al. 2013); where that finds none, over all triangulations, O(n³) (Liepa 2003), for at most
// tolerance::kCubicFillEdges edges. No new vertices. None beyond tolerance::kLibraryFillEdges, and when cancelled.
std::optional<Patch> triangulateMinimal(const HoleContext& hole, Progress progress = {});

// Refines a patch to the density around the hole, and optionally fairs it. Refined after Liepa 2003, with density as
// its factor alpha, or as far as tolerance::kPatchVertices go; with a continuity, bent so that it continues the ring
// (fair()). None when a vertex of the ring has more than tolerance::kLibraryFanFaces faces or the library refuses, and
// when cancelled.
std::optional<Patch> refinePatch(const HoleContext& hole, const Patch& start, std::optional<Continuity> bent,
                                 double density = tolerance::kPatchDensity, Progress progress = {});

}  // namespace handwheel
