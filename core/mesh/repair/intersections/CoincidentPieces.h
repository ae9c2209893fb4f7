// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <cstddef>

namespace handwheel {

// Joins coincident surfaces after autorefine() has cut them to equal pieces. Pieces are the faces from firstPiece on;
// others with the same corners stay. Connected pieces are treated alike:
// - Facing each other, where two solids touch: both are removed, and the solids become one. Winding numbers stay.
// - Facing each other, but needed to keep the surface closed: those that agree with their neighbours stay.
// - Facing the same direction: one stays if the surface is no less closed then, as under a flake; otherwise all stay,
//   as where two solids have a common base (uniteAtWalls()).
// The sides of a separate plate stay. Returns the number of removed faces; the caller must relink() the mesh. O(n). The
// mesh is invalid if cancelled.
std::size_t joinCoincidentPieces(HalfEdgeMesh& mesh, Face firstPiece, Progress progress = {});

}  // namespace handwheel
