// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HoleFilling.h"

#include <span>

namespace handwheel {

// Closes loops that neither a patch nor a cut closes (closeHardHoles()), because faces around them cross each other or
// lie on each other: takes those faces out, where that is not enough with rings of faces around them, and fills what is
// laid open, as one would by hand. Takes only what leaves fewer edges without two faces, no more crossings and no loop,
// moves no point of the surface by more than tolerance::kTangleMove of the mesh's diagonal, and of a body that goes
// whole by kTangleBodyMove. Loops with FillOptions::keptCorners stay as they are. Returns how many faces of the mesh
// were taken out. Takes no more than tolerance::kTangleEffort, nor than the effort of the progress. O(n) for each
// trial, the rest in proportion to the faces near the loop. Once somebody cancelled it, the mesh is not to be used.
std::size_t replaceTangles(HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, const FillOptions& options,
                           Progress progress = {});

}  // namespace handwheel
