// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"

#include <span>
#include <vector>

namespace handwheel {

// Connects an island with the hole around it by two triangles (findBridge()). Both become one loop. Among the
// nearest pairs of points, the first whose bridge is not obstructed is taken. An island whose faces look the other
// direction is reversed. hole and island must be loops of this mesh; island is the outer boundary of an open piece.
// Returns false, and leaves the mesh unchanged, if every bridge that was tried is obstructed. O(n), and O(h k) for
// loops of h and k edges.
bool bridgeIsland(HalfEdgeMesh& mesh, const BoundaryLoop& hole, const BoundaryLoop& island);

}  // namespace handwheel
