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
  double corner = 0.0;  // not 0: the segment marks a corner that is rounded (turn not 0) or chamfered by this much

  // Returns the length, for an arc at most its radius. Half of it bounds the offset that the segment allows.
  double size() const;
  double radius() const { return std::abs(from - centre); }
  // Returns true if it goes on in -z all along, and bends no further than to -z.
  bool isMonotonic() const;
  void move(const PlanePoint& by);
  void offset(double distance);  // to the left in the sense of -z: away from the part
  void mirrorRadius();
  void mirrorLength();
  void turnQuarter();  // clockwise

  // Returns the z values at which it has this radius; for an arc, the higher z first.
  std::vector<double> crossings(double radius) const;
};

// The receivers of the moves of a cycle.
struct CycleOutput {
  std::function<void(const PlanePoint&)> rapid, feed;
  std::function<void(int turn, const PlanePoint& centre, const PlanePoint& to)> arc;
};

// Moves the end of `a` and the beginning of `b` to the intersection of the two, extended. Returns false if they are
// parallel.
bool meet(ContourSegment& a, ContourSegment& b);

}  // namespace handwheel
