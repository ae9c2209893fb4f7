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
  // Both must outlive it.
  HoleBridgeSearch(const HoleContext& hole, const Obstacles& obstacles);

  // The free bridge with the least length relative to the shorter part of the border that it cuts off, at least a
  // quarter of the piece's edges on either side. piece: numbers of loop points, in the loop's order; the bridge: places
  // in it. None when none of the likely ones is free, and if cancelled. Examines some 2^15 pairs of points, however
  // many there are.
  std::optional<HoleBridge> best(const std::vector<std::uint32_t>& piece, Progress progress = {}) const;

 private:
  struct Piece;
  struct Ranked;
  HoleBridge improved(const Piece& piece, const Ranked& rough, std::size_t stride) const;
  bool isFree(const Piece& piece, const HoleBridge& s) const;
  bool hasFreeSide(const Piece& piece, std::size_t a, std::size_t b) const;

  const HoleContext& m_hole;
  const Obstacles& m_obstacles;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> m_edges;  // of the surface, among the loop's points
};

}  // namespace handwheel
