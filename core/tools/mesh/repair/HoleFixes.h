// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"
#include "tools/mesh/MeshServices.h"

#include <vector>

namespace handwheel {

// Changes that close openings that "Repair all" leaves open, with their script steps.

// Turns open sheets into thin bodies. loops: the outer edges of the sheets, by their smallest vertex (keyOf()).
// thickness: the thickness of the bodies, mm; 0: defaultSheetThickness().
MeshChange thickenFix(std::vector<Vertex> loops, const FillOptions& options, double thickness = 0.0);
// Closes a loop even if every patch would intersect the part. The patch and the part are cut where they intersect.
MeshChange cutAndCloseFix(Vertex loop, const FillOptions& options);

}  // namespace handwheel
