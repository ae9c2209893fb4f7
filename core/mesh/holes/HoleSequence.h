// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleFiller.h"

#include <span>

namespace handwheel {

// The result of filling one boundary loop.
struct HoleFill {
  FillAttempt attempt;
  double milliseconds = 0.0;
};

// Fills boundary loops of the mesh, small ones first. These are the surest, and a large patch must respect them. When a
// patch that bulges obstructs another, it is made again without its bulge, if then fewer loops stay open. One result to
// each loop. Where the effort of the progress is spent, the other loops stay open. The mesh is invalid if the user
// cancelled.
std::vector<HoleFill> fillHoles(HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, const FillOptions& options,
                                Progress progress = {});

}  // namespace handwheel
