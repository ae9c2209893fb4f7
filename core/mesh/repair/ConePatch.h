// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/holes/Patch.h"

namespace handwheel {

// Returns a patch of triangles from the loop to an apex over the loop's centre. height is the outward distance of the
// apex in units of the loop's shortest edge. O(n).
Patch conePatch(const HalfEdgeMesh& mesh, const BoundaryLoop& loop, double height, NumberType numbers);

}  // namespace handwheel
