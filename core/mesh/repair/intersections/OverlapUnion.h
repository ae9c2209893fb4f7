// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <cstddef>

namespace handwheel {

// Which overlapping solids become one.
enum class Uniting {
  SharedWalls,  // those that share parts of a wall: their surfaces cannot be separated without a crack
  AllSolids     // all that were cut along each other
};

// Unites overlapping solids. These are cut to equal pieces before (autorefine()), and what cancels is joined
// (joinCoincidentPieces()). Of walls on each other, which face the same way, one stays; and the walls inside the union
// go, from those that end at a shared wall, or at any wall, on. Which these are is decided by the winding numbers on
// both sides of each wall, counted over what hangs together with it; nothing is done where these are no whole numbers,
// because the surface is open, or negative, because a body is inside out. Pieces are the faces from firstPiece on.
// Returns the number of removed faces; relink() is to follow. O(n) for the mesh and, for each such wall, O(m) for the m
// faces of its solids. The mesh is invalid if cancelled.
std::size_t uniteAtWalls(HalfEdgeMesh& mesh, Face firstPiece, Uniting which, Progress progress = {});

}  // namespace handwheel
