// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/holes/Patch.h"

namespace handwheel {

// A patch of triangles to one apex over the middle of the loop's points. height: in the loop's shortest edges, towards
// the outside. O(n).
Patch conePatch(const HalfEdgeMesh& mesh, const BoundaryLoop& loop, double height, NumberType numbers);

}  // namespace handwheel
