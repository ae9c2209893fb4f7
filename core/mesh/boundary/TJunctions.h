// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// Splits border edges at border vertices that lie on them (T-junctions). The distance of the vertex from the edge must
// be at most nearWeldReach(), and at most tolerance::kNearWeldEdge times the length of the edge. Vertices marked in
// "fixed" are ignored; this list may be shorter than the number of vertices. The caller must relink the mesh: until
// then, only the distinction between border and inner edges is valid. Returns the number of splits. If cancelled, some
// T-junctions may remain.
std::size_t splitTJunctions(HalfEdgeMesh& mesh, const std::vector<bool>& fixed, Progress progress, double nearWeld);

}  // namespace handwheel
