// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/PositionTriangles.h"

namespace handwheel {

// Marks the outer boundary loops of open sheets as rims. An open sheet, rather than a surface with holes, is a flat
// part, a thin one with a long outline, or a frayed one, as a single-view scan is. A patch over such a loop would cover
// the sheet with a second layer. Where the largest part is a frayed sheet, or a flat one is all there is, the rims are
// also marked as those of a picture. If cancelled, none is marked.
void markRims(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition, std::vector<BoundaryLoop>& loops,
              Progress progress = {});

}  // namespace handwheel
