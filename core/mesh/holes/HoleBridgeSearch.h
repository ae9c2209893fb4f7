// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "mesh/holes/HoleContext.h"
#include "mesh/holes/Obstacles.h"
#include "mesh/holes/Patch.h"

#include <optional>
#include <vector>

namespace handwheel {

// Searches for the best bridge that divides a piece of a loop.
class HoleBridgeSearch {
 public:
  // hole and obstacles must outlive the object.
  HoleBridgeSearch(const HoleContext& hole, const Obstacles& obstacles);

  // Returns the unobstructed bridge with the least length relative to the shorter part of the border that it cuts off.
  // At least a quarter of the piece's edges must be on each side. piece contains indices of loop points, in the loop's
  // order; the returned bridge contains indices of elements of piece. Returns nothing if all examined bridges are
  // obstructed, or if cancelled. The function examines about 2^15 pairs of points, regardless of the size of the piece.
  std::optional<HoleBridge> best(const std::vector<std::uint32_t>& piece, Progress progress = {}) const;

 private:
  struct Piece;
  struct Ranked;
  HoleBridge improved(const Piece& piece, const Ranked& rough, std::size_t stride) const;
  bool isFree(const Piece& piece, const HoleBridge& s) const;
  bool hasFreeSide(const Piece& piece, std::size_t a, std::size_t b) const;

  const HoleContext& m_hole;
  const Obstacles& m_obstacles;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> m_edges;  // edges of the surface between loop points
};

}  // namespace handwheel
