// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/HalfEdgeMesh.h"

namespace handwheel {

// Once cancelled, the mesh is of no use: each leaves off halfway.

// Removes faces of exactly zero area. A needle between two neighbours is flipped away (the long edge's other face is
// split at the middle vertex, which changes no geometry); others are simply dropped. Returns how many faces went.
// Leaves the mesh linked.
std::size_t removeDegenerateFaces(HalfEdgeMesh& mesh, Progress progress = {});

// Removes flaps: small faces (tolerance::kFlap) that share no edge with exactly one other face, and hang by at least
// one edge on faces that do. Nothing opens without them, and closing them would double them. Returns how many went.
// Relinks.
std::size_t removeFlaps(HalfEdgeMesh& mesh, Progress progress = {});

// Removes the parts that findDefects() calls debris. Returns how many faces went.
std::size_t removeDebris(HalfEdgeMesh& mesh, Progress progress = {});

}  // namespace handwheel
