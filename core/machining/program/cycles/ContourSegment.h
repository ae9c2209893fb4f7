// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/NoseCompensation.h"

#include <functional>
#include <vector>

namespace handwheel {

// A straight line or an arc of the contour that a roughing cycle cuts. Lengths are in units of the program; r is a
// radius.
struct ContourSegment {
  int turn = 0;  // 0: straight; 1 counter-clockwise in the plane of z and r, -1 clockwise
  PlanePoint from, to, centre;
  double corner = 0.0;  // size of the rounding (turn not 0) or chamfer that the segment marks; 0: none

  // Returns the size of the segment, which is its length, for an arc at most its radius. The segment can be offset by
  // at most half of its size.
  double size() const;
  double radius() const { return std::abs(from - centre); }
  // Returns true if z never rises along the segment.
  bool isMonotonic() const;
  void move(const PlanePoint& by);
  void offset(double distance);  // to the left of the direction -z, away from the part
  void mirrorRadius();
  void mirrorLength();
  void turnQuarter();  // clockwise

  // Returns the z at which the segment has this radius. For an arc, the higher z comes first.
  std::vector<double> crossings(double radius) const;
};

// The functions that receive the moves of a cycle.
struct CycleOutput {
  std::function<void(const PlanePoint&)> rapid, feed;
  std::function<void(int turn, const PlanePoint& centre, const PlanePoint& to)> arc;
};

// Moves the end of `a` and the start of `b` to the intersection of the two segments, which are extended if necessary.
// Returns false if they are parallel.
bool meet(ContourSegment& a, ContourSegment& b);

}  // namespace handwheel
