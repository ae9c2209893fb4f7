// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/selection/FaceSelection.h"

namespace handwheel {

// Removal of degenerate faces and other defects. If cancelled, the functions below leave an invalid mesh.

// Removes faces of exactly zero area. A needle between two neighbours is flipped (the other face of the long edge is
// split at the middle vertex, which changes no geometry); other faces of zero area are simply removed. Returns the
// number of removed faces. If "only" is not null, the removal is restricted to its faces and to faces connected with
// them through edges, because a needle between needles cannot be flipped alone. The mesh stays linked.
std::size_t removeDegenerateFaces(HalfEdgeMesh& mesh, Progress progress = {}, const FaceSelection* only = nullptr);

// Removes flaps: small faces (tolerance::kFlap) attached to the surface at non-manifold edges only. None of a flap's
// edges is manifold (shared with exactly one other face), and at least one is shared with a face that has a manifold
// edge. Removing flaps opens no edge of the surface, whereas closing the open edges of a flap would add a second layer
// to it. Returns the number of removed faces. Relinks the mesh.
std::size_t removeFlaps(HalfEdgeMesh& mesh, Progress progress = {});

// Removes the components that findDefects() classifies as debris. Returns the number of removed faces.
std::size_t removeDebris(HalfEdgeMesh& mesh, Progress progress = {});

// Removes remnants of cuts: small closed pieces that consist only of faces and vertices that "before" does not have.
// Cutting renumbers a face but keeps its corners. Returns the number of removed faces.
std::size_t removeNewDebris(HalfEdgeMesh& mesh, const HalfEdgeMesh& before, Progress progress = {});

}  // namespace handwheel
