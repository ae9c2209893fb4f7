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

// Fills boundary loops of the mesh, small ones first. Small patches are the most reliable, and large patches must avoid
// them. If a bulging patch obstructs another, the bulging patch is made again without its bulge, provided that fewer
// loops stay open as a result. Returns one result per loop. When the effort of the progress is spent, the remaining
// loops stay open. The mesh is invalid if the user cancelled.
std::vector<HoleFill> fillHoles(HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, const FillOptions& options,
                                Progress progress = {});

}  // namespace handwheel
