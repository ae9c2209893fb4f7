// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// Splits border edges at border vertices that lie on them (T-junctions). That is within this share of the diagonal and
// tolerance::kNearWeldEdge of the edge. Vertices in "fixed" are ignored; it may be shorter than the number of vertices.
// The mesh must be relinked then: until then only what is border and what is not is true. Returns the number of splits.
// When cancelled, some may be left.
std::size_t splitTJunctions(HalfEdgeMesh& mesh, const std::vector<bool>& fixed, Progress progress, double nearWeld);

}  // namespace handwheel
