// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Tolerance.h"
#include "base/WorkBudget.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace handwheel {

// Returns the effort limit for the repair of a mesh with this number of faces. The unit is steps of WorkBudget.
inline std::size_t repairBudget(std::size_t faces) {
  const double n = static_cast<double>(faces) + 2.0;
  return std::max(tolerance::kLeastRepairBudget, static_cast<std::size_t>(tolerance::kRepairBudget * n * std::log2(n)));
}

// Returns the effort limit for one kind of work in the repair of a mesh. It is a fraction (share) of the limit for the
// whole repair, but at most a fixed number of steps plus those of passes over the whole mesh.
inline std::size_t repairBudget(std::size_t faces, double share, std::size_t fixed) {
  return std::min(static_cast<std::size_t>(share * static_cast<double>(repairBudget(faces))),
                  fixed + tolerance::kPassBudget * faces);
}

// The effort limits of one repair.
struct RepairEfforts {
  explicit RepairEfforts(const HalfEdgeMesh& input);

  // Returns the effort limit for one kind of work, like repairBudget(), but less if exact tests are slow. Their time
  // grows with the square of the ratio between the bits of the coordinates and those of ordinary parts.
  std::size_t most(double share, std::size_t fixed) const;

  std::size_t faces;
  double slowness;
  WorkBudget fill;
  WorkBudget close;
  // Separate parts of the budget for closing: for obstructed holes and non-orientable surfaces, for the separation of
  // coincident vertices, and for the removal of folded regions.
  WorkBudget hard, separation, tangle;
};

}  // namespace handwheel
