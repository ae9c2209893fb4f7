// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/selection/FaceSelection.h"

namespace handwheel {

// Removal of degenerate faces and other defects. If cancelled, the functions below leave an invalid mesh.

// Removes faces of exactly zero area. A needle between two neighbours is flipped (the other face of the long edge is
// split at the middle vertex, which changes no geometry); others are simply removed. Returns the number of removed
// faces. only restricts the removal to these faces and those connected with them through edges, because a needle
// between needles cannot be flipped alone; null: all faces. Leaves the mesh linked.
std::size_t removeDegenerateFaces(HalfEdgeMesh& mesh, Progress progress = {}, const FaceSelection* only = nullptr);

// Removes flaps: small faces (tolerance::kFlap) attached to the surface at non-manifold edges only. They share no edge
// with exactly one other face, and at least one edge with faces that do. Removing them opens no edge, and closing them
// would double them. Returns the number of removed faces. Relinks the mesh.
std::size_t removeFlaps(HalfEdgeMesh& mesh, Progress progress = {});

// Removes the components that findDefects() classifies as debris. Returns the number of removed faces.
std::size_t removeDebris(HalfEdgeMesh& mesh, Progress progress = {});

// Removes remnants of cuts: small closed pieces that consist only of faces and vertices that the mesh did not have
// before. Cutting renumbers a face but keeps its corners. Returns the number of removed faces.
std::size_t removeNewDebris(HalfEdgeMesh& mesh, const HalfEdgeMesh& before, Progress progress = {});

}  // namespace handwheel
