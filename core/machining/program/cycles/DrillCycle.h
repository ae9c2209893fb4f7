// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramMachine.h"

namespace handwheel {

// Drilling along z in steps (G73, G81 to G83, G85, G89). Lengths in mm.
struct DrillCycle {
  static constexpr double kClearance = 0.254;  // before what is drilled already: 0.010 inch

  double radius = 0.0;   // where it drills
  double depth = 0.0;    // z of the bottom
  double retract = 0.0;  // z where it begins to feed
  double end = 0.0;      // z where it goes at last
  double peck = 0.0;     // 0: none
  bool isDeep = false;   // goes back to `retract` after each step
  bool feedsOut = false;
  double dwell = 0.0;  // s

  void run(ProgramMachine& machine, const ProgramPlace& place) const;
};

}  // namespace handwheel
