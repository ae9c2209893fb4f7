// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/holes/Creases.h"
#include "mesh/holes/Patch.h"

#include <array>
#include <vector>

namespace handwheel {

// A crease across a hole, from one point of its loop to another.
struct Crease {
  CreaseEnd from, to;
  std::vector<Vec3> curve;  // the points between the ends, with the spacing of the points around the hole
  HoleBridge bridge() const { return {from.chain.front(), to.chain.front()}; }
};

// Three creases that meet in a missing corner of the part inside a hole. The ends are in the loop's order.
struct CreaseCorner {
  std::array<CreaseEnd, 3> ends;
  Vec3 point = Vec3::Zero();
  std::array<std::vector<Vec3>, 3> curves;  // straight, from each end to the point, without either
};

// The creases and crease corners across a hole.
struct Creases {
  std::vector<Crease> pairs;
  std::vector<CreaseCorner> corners;
};

// Connects the ends of creases at a hole that belong together. First come pairs that point at each other with similar
// angles, the most certain first, then triples that point at one position (or one that points at the loop point where
// two others end), then pairs that point at each other roughly. No two creases cross. A pair is connected by the cubic
// that starts at each end in its direction, with the length of a circular arc. density has the meaning of FillOptions.
// Returns nothing if more than 64 creases end at the hole: the surface is rough.
Creases matchCreases(const HoleContext& hole, const std::vector<CreaseEnd>& ends, double density);

}  // namespace handwheel
