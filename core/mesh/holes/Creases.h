// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleContext.h"

#include <vector>

namespace handwheel {

// The end of a surface crease at a hole.
struct CreaseEnd {
  // Points of the context: from the loop back into the surface. Where the crease ran on as the loop's own edge, more
  // than the first of them are the loop's; nothing behind those edges belongs to the crease's other side.
  std::vector<std::uint32_t> chain;
  Vec3 direction = Vec3::Zero();  // in which it goes on over the hole, of length 1
  double angle = 0.0;             // between its sides, 0 where flat; negative in a valley (radian)
};

// Finds the ends of all creases at a hole. The sides of a crease meet at more than this angle (radian), and it is seen
// over two edges, or one where it comes from a corner of the part. O(n) for n faces around the hole.
std::vector<CreaseEnd> findCreaseEnds(const HoleContext& hole, double angle);

}  // namespace handwheel
