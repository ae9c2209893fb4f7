// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/selection/FaceSelection.h"

namespace handwheel {

// Removal of degenerate faces and other defects. The functions below stop halfway when cancelled: the mesh is invalid
// then.

// Removes faces of exactly zero area. A needle between two neighbours is flipped away (the long edge's other face is
// split at the middle vertex, which changes no geometry); others are simply removed. Returns the number of removed
// faces. only: these, and those that hang together with them through edges, because a needle between needles cannot be
// flipped alone; null for all. Leaves the mesh linked.
std::size_t removeDegenerateFaces(HalfEdgeMesh& mesh, Progress progress = {}, const FaceSelection* only = nullptr);

// Removes flaps: small faces (tolerance::kFlap) attached to the surface at non-manifold edges only. They share no edge
// with exactly one other face, and at least one edge with faces that do. Nothing opens without them, and closing them
// would double them. Returns the number of removed faces. Relinks.
std::size_t removeFlaps(HalfEdgeMesh& mesh, Progress progress = {});

// Removes the components that findDefects() classifies as debris. Returns the number of removed faces.
std::size_t removeDebris(HalfEdgeMesh& mesh, Progress progress = {});

// Removes what cuts left behind: small closed pieces of nothing but faces and vertices that the mesh did not have
// before. Cutting renumbers a face, but its corners remain those that it had. Returns the number of faces.
std::size_t removeNewDebris(HalfEdgeMesh& mesh, const HalfEdgeMesh& before, Progress progress = {});

}  // namespace handwheel
