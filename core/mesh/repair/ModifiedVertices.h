// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// Differences between two versions of a mesh, by the indices of the earlier version. The results are invalid if
// cancelled.

// Counts the faces whose orientation over the same three positions is reversed. O(n).
std::size_t countReversedFaces(const HalfEdgeMesh& before, const HalfEdgeMesh& after, Progress progress = {});

// Returns the vertices whose position changed, and all vertices at the given positions, sorted. O(n log n), or O(n) if
// no positions are given.
std::vector<Vertex> modifiedVertices(const HalfEdgeMesh& before, const HalfEdgeMesh& after, std::vector<Vec3> positions,
                                     Progress progress = {});

}  // namespace handwheel
