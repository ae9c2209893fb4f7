// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/Patch.h"
#include "mesh/Ridges.h"

#include <array>
#include <vector>

namespace handwheel {

// A crease over the hole, from one point of its loop to another.
struct Ridge {
  RidgeEnd from, to;
  std::vector<Vec3> curve;  // the points between the ends, as near to each other as those around the hole
  Stitch stitch() const { return {from.chain.front(), to.chain.front()}; }
};

// Three creases that meet over the hole, where a corner of the part is missing; the ends in the loop's order.
struct RidgeCorner {
  std::array<RidgeEnd, 3> ends;
  Vec3 point = Vec3::Zero();
  std::array<std::vector<Vec3>, 3> curves;  // straight, from each end to the point, both left out
};

struct Ridges {
  std::vector<Ridge> pairs;
  std::vector<RidgeCorner> corners;
};

// Joins ends that belong together: pairs that point at each other and bend alike, the surest first, then threes that
// point at one place (or one at the point of the loop where two others end), then pairs that point at each other
// roughly. None crosses another. Between a pair runs the cubic
// that leaves either end in its direction, as long as a circle's arc would be. density: as FillOptions has it. None
// where more than 64 creases end: a rough surface.
Ridges matchRidges(const HoleContext& hole, const std::vector<RidgeEnd>& ends, double density);

}  // namespace handwheel
