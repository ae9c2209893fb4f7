// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <cstddef>

namespace handwheel {

// Joins surfaces that lie on each other, once they are cut to equal pieces (autorefine()). Pieces are the faces from
// firstPiece on; others with the same corners stay. Those that hang together are treated alike:
// - Facing each other, where two solids touch: both go, and the solids become one. Winding numbers stay.
// - Facing each other, but not closed without them: those stay that agree with their neighbours.
// - Facing the same way: one stays where the surface is no less closed then, as under a flake; else all do, as where
//   two solids have a common base (uniteAtWalls()).
// The sides of a plate that stands alone stay. Returns the number of removed faces; relink() is to follow. O(n). The
// mesh is invalid if cancelled.
std::size_t joinCoincidentPieces(HalfEdgeMesh& mesh, Face firstPiece, Progress progress = {});

}  // namespace handwheel
