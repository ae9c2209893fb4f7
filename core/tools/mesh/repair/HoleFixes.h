// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"
#include "tools/mesh/MeshServices.h"

#include <vector>

namespace handwheel {

// The changes that close openings which "Repair all" leaves, with their steps. They complement those of DefectFixes.h.

// Turns open sheets into thin bodies. loops: outer edges of the sheets, by their smallest vertex (keyOf()). thickness:
// mm; 0: defaultSheetThickness().
MeshChange thickenFix(std::vector<Vertex> loops, const FillOptions& options, double thickness = 0.0);
// Closes a loop although every patch would intersect the part. The patch is cut apart where it crosses.
MeshChange cutAndCloseFix(Vertex loop, const FillOptions& options);

}  // namespace handwheel
