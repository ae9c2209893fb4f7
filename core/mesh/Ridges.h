// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HoleContext.h"

#include <vector>

namespace handwheel {

// Where a crease of the surface ends at a hole.
struct RidgeEnd {
  // Points of the context: from the loop back into the surface. Where the crease ran on as the loop's own edge, more
  // than the first of them are the loop's; nothing behind those edges belongs to the crease's other side.
  std::vector<std::uint32_t> chain;
  Vec3 direction = Vec3::Zero();  // in which it goes on over the hole, of length 1
  double angle = 0.0;             // between its sides, 0 where flat; negative in a valley (radian)
};

// The ends of all creases whose sides meet at more than this angle (radian) and that are seen over two edges, or one
// where they come from a corner of the part. O(n) for n faces around the hole.
std::vector<RidgeEnd> findRidgeEnds(const HoleContext& hole, double angle);

}  // namespace handwheel
