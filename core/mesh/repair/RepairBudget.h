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

// The effort limit for the repair of a mesh of this many faces. In steps of Effort.
inline std::size_t repairBudget(std::size_t faces) {
  const double n = static_cast<double>(faces) + 2.0;
  return std::max(tolerance::kLeastRepairBudget, static_cast<std::size_t>(tolerance::kRepairBudget * n * std::log2(n)));
}

// What one kind of work on such a mesh may take: a share of that, but no more than a fixed number of steps and those
// that passes over all of the mesh take.
inline std::size_t repairBudget(std::size_t faces, double share, std::size_t fixed) {
  return std::min(static_cast<std::size_t>(share * static_cast<double>(repairBudget(faces))),
                  fixed + tolerance::kPassBudget * faces);
}

// What one repair may take.
struct RepairEfforts {
  explicit RepairEfforts(const HalfEdgeMesh& input);

  // What one kind of work may take: as repairBudget(), but less where exact tests are slow. Those take the square of
  // what coordinates have more bits than those of parts have.
  std::size_t most(double share, std::size_t fixed) const;

  std::size_t faces;
  double slowness;
  WorkBudget fill;
  WorkBudget close;
  WorkBudget hard, separation, tangle;  // shares of that for closing, each its own
};

}  // namespace handwheel
