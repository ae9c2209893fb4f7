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
  std::vector<Vec3> curve;  // points between the ends, spaced like the points around the hole
  HoleBridge bridge() const { return {from.chain.front(), to.chain.front()}; }
};

// Three creases that meet in a missing corner of the part inside a hole. The ends are in the loop's order.
struct CreaseCorner {
  std::array<CreaseEnd, 3> ends;
  Vec3 point = Vec3::Zero();
  std::array<std::vector<Vec3>, 3> curves;  // straight lines from the ends to the corner, without their end points
};

// The creases and crease corners across a hole.
struct Creases {
  std::vector<Crease> pairs;
  std::vector<CreaseCorner> corners;
};

// Connects the ends of creases at a hole that belong together. Pairs that point at each other with similar angles are
// connected first, the most certain ones before the others; then triples that point at one position (or of which one
// points at the loop point where the two others end); then pairs that roughly point at each other. No two creases
// cross. A pair is connected by the cubic curve that starts at each end in its direction, with tangents that
// approximate a circular arc. density has the same meaning as in FillOptions. The result is empty if more than 64
// creases end at the hole, because the surface is then merely rough.
Creases matchCreases(const HoleContext& hole, const std::vector<CreaseEnd>& ends, double density);

}  // namespace handwheel
