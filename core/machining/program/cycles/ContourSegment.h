// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/NoseCompensation.h"

#include <functional>
#include <vector>

namespace handwheel {

// A straight line or an arc of the contour that a roughing cycle cuts. Lengths are in units of the program, radii.
struct ContourSegment {
  int turn = 0;  // 0: straight; 1 counter-clockwise in the plane of z and r, -1 clockwise
  PlanePoint from, to, centre;
  double corner = 0.0;  // not 0: the place of a corner that is rounded (turn not 0) or chamfered by this much

  // Straight, half of the length bounds what an offset may do to it; of an arc its radius too.
  double size() const;
  double radius() const { return std::abs(from - centre); }
  // Whether it goes on in -z all the way, and bends no further than to -z.
  bool isMonotonic() const;
  void move(const PlanePoint& by);
  void offset(double distance);  // to its left, seen along -z: away from the part
  void mirrorRadius();
  void mirrorLength();
  void turnQuarter();  // clockwise

  // The z at which it has this radius; of an arc the one at the higher z first.
  std::vector<double> crossings(double radius) const;
};

// Where the moves of a cycle go.
struct CycleOutput {
  std::function<void(const PlanePoint&)> rapid, feed;
  std::function<void(int turn, const PlanePoint& centre, const PlanePoint& to)> arc;
};

// Moves the end of `a` and the beginning of `b` to where the two, extended, meet. False where they are parallel.
bool meet(ContourSegment& a, ContourSegment& b);

}  // namespace handwheel
