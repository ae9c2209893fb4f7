// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramMachine.h"

namespace handwheel {

// A cycle that drills along z in steps (G73, G81 to G83, G85, G89). Lengths are in mm.
struct DrillCycle {
  static constexpr double kClearance = 0.254;  // distance from the drilled depth at which a feed begins, 0.01 inch

  double radius = 0.0;   // radius of the hole's axis
  double depth = 0.0;    // z of the bottom
  double retract = 0.0;  // z at which the feed begins
  double end = 0.0;      // z at the end of the cycle
  double peck = 0.0;     // depth of a peck; 0: the hole is drilled in one step
  bool isDeep = false;   // the drill goes back to `retract` after each step
  bool feedsOut = false;
  double dwell = 0.0;  // s, time at the bottom

  void run(ProgramMachine& machine, const SourceLocation& location) const;
};

}  // namespace handwheel
