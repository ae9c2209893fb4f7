// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <cstddef>

namespace handwheel {

// Unites overlapping solids that share parts of a wall. The walls face the same way; solids are cut to equal pieces
// before (autorefine()) and what cancels is joined (joinCoincidentPieces()). Two such walls cannot be separated without
// a crack, so one stays, and with the others go the walls inside the union that end at them. Which these are is decided
// by the winding numbers on both sides of each wall, counted over what hangs together with it; nothing is done where
// these are no whole numbers, because the surface is open, or negative, because a body is inside out. Pieces are the
// faces from firstPiece on. Returns the number of removed faces; relink() is to follow. O(n) for the mesh and, for each
// such wall, O(m) for the m faces of its solids. The mesh is invalid if cancelled.
std::size_t uniteAtSharedWalls(HalfEdgeMesh& mesh, Face firstPiece, Progress progress = {});

}  // namespace handwheel
