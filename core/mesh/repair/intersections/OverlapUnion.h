// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <cstddef>

namespace handwheel {

// The choice of overlapping solids to unite.
enum class Uniting {
  SharedWalls,  // solids that share parts of a wall: their surfaces cannot be separated without a crack
  AllSolids     // all solids that were cut along each other
};

// Unites overlapping solids. They must be cut to equal pieces (autorefine()), and opposite coincident pieces joined
// (joinCoincidentPieces()). Of coincident walls that face the same direction, one stays. Walls inside the union are
// removed, starting from those that end at a shared wall (SharedWalls) or at any wall (AllSolids). The winding numbers
// on both sides of a wall, counted over its connected surfaces, decide whether it is inside; nothing is done if these
// numbers are not integers, because the surface is open, or are negative, because a body is inside out. Pieces are the
// faces from firstPiece on. Returns the number of removed faces; the caller must relink() the mesh. O(n) for the mesh
// and, for each such wall, O(m) for the m faces of its solids. The mesh is invalid if cancelled.
std::size_t uniteAtWalls(HalfEdgeMesh& mesh, Face firstPiece, Uniting which, Progress progress = {});

}  // namespace handwheel
