// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/HoleContext.h"

#include <vector>

namespace handwheel {

// The end of a surface crease at a hole.
struct CreaseEnd {
  // Indices into HoleContext::points, from the loop back into the surface. If the crease runs along edges of the loop,
  // several of the first points are on the loop; at those edges, the faces of the other side of the crease are missing.
  std::vector<std::uint32_t> chain;
  Vec3 direction = Vec3::Zero();  // unit vector of the crease's continuation over the hole
  double angle = 0.0;             // angle between the sides of the crease, radian; 0 if flat, negative in a valley
};

// Finds the ends of all creases at a hole. The sides of a crease meet at more than this angle (radian) over at least
// two edges, or over one edge that starts at a corner of the part. O(n) for n faces around the hole.
std::vector<CreaseEnd> findCreaseEnds(const HoleContext& hole, double angle);

}  // namespace handwheel
