// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Tolerance.h"
#include "mesh/Fairing.h"
#include "mesh/HoleContext.h"
#include "mesh/Patch.h"

#include <optional>

namespace handwheel {

// CGAL's hole triangulation by dihedral angle and area: first with the edges of the Delaunay tetrahedrisation, O(n log
// n) (Zou et al. 2013); where that finds none, over all triangulations, O(n³) (Liepa 2003), for at most
// tolerance::kCubicFillEdges edges. No new vertices. None beyond tolerance::kLibraryFillEdges.
std::optional<Patch> triangulateMinimal(const HoleContext& hole);

// Refines a patch to the density around the hole (Liepa 2003; density is its factor alpha), or as far as
// tolerance::kPatchVertices go, and, with a continuity, bends it so that it continues the ring (fair()). None when a
// vertex of the ring has more than tolerance::kLibraryFanFaces faces or the library refuses.
std::optional<Patch> refinePatch(const HoleContext& hole, const Patch& start, std::optional<Continuity> bent,
                                 double density = tolerance::kPatchDensity);

}  // namespace handwheel
