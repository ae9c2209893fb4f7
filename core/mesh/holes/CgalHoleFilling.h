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

// Triangulates a hole with CGAL so that dihedral angles and area are minimal. The first search uses the edges of the
// Delaunay tetrahedrisation, O(n log n) (Zou, Ju, Carr, "An algorithm for triangulating multiple 3D polygons", 2013).
// If it fails, the second search covers all triangulations, O(n³) (Liepa, "Filling holes in meshes", 2003), for at most
// tolerance::kCubicFillEdges edges. No vertices are added. Returns nothing if the loop has more than
// tolerance::kLibraryFillEdges edges, if both searches fail, or if cancelled.
std::optional<Patch> triangulateMinimal(const HoleContext& hole, Progress progress = {});

// Refines a patch to the density around the hole, and optionally fairs it. The refinement follows Liepa 2003, with
// density as its factor alpha, up to tolerance::kPatchVertices vertices; if bent is set, fair() then bends the patch so
// that it continues the faces around the hole with this continuity. Returns nothing if a vertex of these has more than
// tolerance::kLibraryFanFaces faces, if CGAL refuses the patch, or if cancelled.
std::optional<Patch> refinePatch(const HoleContext& hole, const Patch& start, std::optional<Continuity> bent,
                                 double density = tolerance::kPatchDensity, Progress progress = {});

}  // namespace handwheel
