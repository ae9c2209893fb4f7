// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
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

}  // namespace handwheel
