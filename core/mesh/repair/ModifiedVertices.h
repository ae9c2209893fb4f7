// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// What a later version of a mesh has changed of it, by the numbers of the earlier one. Both are invalid if cancelled.

// How many faces run the other way over the same three positions. O(n).
std::size_t countReversedFaces(const HalfEdgeMesh& before, const HalfEdgeMesh& after, Progress progress = {});

// The vertices that are elsewhere now, and all at these places, sorted. O(n log n), or O(n) where there are none.
std::vector<Vertex> modifiedVertices(const HalfEdgeMesh& before, const HalfEdgeMesh& after, std::vector<Vec3> places,
                                     Progress progress = {});

}  // namespace handwheel
