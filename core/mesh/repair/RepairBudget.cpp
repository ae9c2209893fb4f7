// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/RepairBudget.h"

#include "mesh/structure/BitRange.h"

namespace handwheel {

RepairEfforts::RepairEfforts(const HalfEdgeMesh& input)
    : faces(input.liveFaceCount()),
      slowness(std::max(1.0, std::pow(static_cast<double>(bitsOf(input)) / tolerance::kCutBits, 2))),
      fill(repairBudget(faces)),
      close(most(1.0, fill.left())),
      hard(most(tolerance::kObstructedHoleShare, tolerance::kObstructedHoleBudget), close),
      separation(most(tolerance::kSeparationShare, tolerance::kObstructedHoleBudget), close),
      tangle(most(tolerance::kFoldedRegionShare, tolerance::kFoldedRegionBudget), close) {}

std::size_t RepairEfforts::most(double share, std::size_t fixed) const {
  return repairBudget(faces, share / slowness, fixed);
}

}  // namespace handwheel
