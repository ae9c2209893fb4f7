// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HoleFilling.h"

#include <span>

namespace handwheel {

struct LoopFill {
  FillAttempt attempt;
  double milliseconds = 0.0;
};

// Fills loops of the mesh, small ones first: they are the surest, and a large patch must respect them. When a patch
// that bulges stands in the way of another, it is made again without its bulge, if then fewer loops stay open. One
// result to each loop. Where the effort of the progress is spent, the other loops stay open. When somebody cancelled
// it, the mesh is not to be used.
std::vector<LoopFill> fillLoops(HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, const FillOptions& options,
                                Progress progress = {});

}  // namespace handwheel
