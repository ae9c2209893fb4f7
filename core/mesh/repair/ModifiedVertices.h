// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// Differences between two versions of a mesh, by the indices of the earlier one. Both are invalid if cancelled.

// How many faces run the other way over the same three positions. O(n).
std::size_t countReversedFaces(const HalfEdgeMesh& before, const HalfEdgeMesh& after, Progress progress = {});

// The vertices that are elsewhere now, and all at these places, sorted. O(n log n), or O(n) where there are none.
std::vector<Vertex> modifiedVertices(const HalfEdgeMesh& before, const HalfEdgeMesh& after, std::vector<Vec3> places,
                                     Progress progress = {});

}  // namespace handwheel
