// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/BoundaryLoops.h"
#include "mesh/PositionTriangles.h"

namespace handwheel {

// Sets rim on the outer edge of every part that is an open sheet rather than a surface with holes: a flat part, a thin
// one with a long outline, or a frayed one, as the view of a scanner from one side is. A patch over such a loop would
// cover the sheet with a second skin. Where the largest part is a frayed sheet, or a flat one is all there is, the rims
// are those of a picture. Once cancelled, none is marked.
void markRims(const HalfEdgeMesh& mesh, const PositionTriangles& byPosition, std::vector<BoundaryLoop>& loops,
              Progress progress = {});

}  // namespace handwheel
