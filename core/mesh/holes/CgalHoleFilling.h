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

// Triangulates a hole with CGAL, by dihedral angle and area. The first search uses the edges of the Delaunay
// tetrahedrisation, O(n log n) (Zou et al. 2013); if it fails, the second covers all triangulations, O(n³) (Liepa
// 2003), for at most tolerance::kCubicFillEdges edges. No vertices are added. Returns nothing beyond
// tolerance::kLibraryFillEdges edges or if cancelled.
std::optional<Patch> triangulateMinimal(const HoleContext& hole, Progress progress = {});

// Refines a patch to the density around the hole, and optionally fairs it. The refinement follows Liepa 2003, with
// density as its factor alpha, up to tolerance::kPatchVertices vertices; with a continuity, fair() bends the patch so
// that it continues the ring. Returns nothing if a vertex of the ring has more than tolerance::kLibraryFanFaces faces,
// if the library refuses, or if cancelled.
std::optional<Patch> refinePatch(const HoleContext& hole, const Patch& start, std::optional<Continuity> bent,
                                 double density = tolerance::kPatchDensity, Progress progress = {});

}  // namespace handwheel
