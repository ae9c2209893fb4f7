// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramMachine.h"

namespace handwheel {

// Drilling along z in steps (G73, G81 to G83, G85, G89). Lengths in mm.
struct DrillCycle {
  static constexpr double kClearance = 0.254;  // before the drilled depth: 0.010 inch

  double radius = 0.0;   // radius of the hole's axis
  double depth = 0.0;    // z of the bottom
  double retract = 0.0;  // z at which the feed begins
  double end = 0.0;      // z at the end of the cycle
  double peck = 0.0;     // depth of a peck; 0: none
  bool isDeep = false;   // goes back to `retract` after each step
  bool feedsOut = false;
  double dwell = 0.0;  // s

  void run(ProgramMachine& machine, const SourceLocation& location) const;
};

}  // namespace handwheel
