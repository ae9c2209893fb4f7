// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <cstddef>

namespace handwheel {

// Joins coincident surfaces after autorefine() has cut them to equal pieces. Pieces are the faces from firstPiece on;
// other faces with the same corners stay. Connected pieces are treated alike:
// - If two pieces face each other where two solids touch, both are removed, and the solids become one. Winding numbers
//   do not change.
// - If pieces face each other, but are needed to keep the surface closed, those that agree with their neighbours stay.
// - If pieces face the same direction, one of them stays if this leaves the surface as closed as before, for
//   example if one belongs to a thin flake on the surface. Otherwise all stay, for example where two solids have a
//   common base (uniteAtWalls()).
// The sides of a separate plate stay. Returns the number of removed faces; the caller must relink() the mesh. O(n). The
// mesh is invalid if cancelled.
std::size_t joinCoincidentPieces(HalfEdgeMesh& mesh, Face firstPiece, Progress progress = {});

}  // namespace handwheel
