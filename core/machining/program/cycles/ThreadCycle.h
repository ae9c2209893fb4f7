// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramMachine.h"

namespace handwheel {

// The passes of a thread (G76). Each pass is parallel to the drive line, the line beside the thread on which the tool
// begins and returns, and is deeper than the one before; the tool is fed along one flank.
//
// Pass n is firstDepth·n^(1/degression) below the peaks. With a degression of 1 all passes cut the same depth; with 2
// all chips have the same area. Lengths are in mm and depths are along r. The start must be at the distance `peak` from
// the peaks.
struct ThreadCycle {
  ProfilePoint start{0, 0};  // (r, z), on the drive line
  double endZ = 0.0;
  double pitch = 1.0;
  double peak = 1.0;  // distance from the drive line to the peaks of the thread
  bool isInside = false;
  double firstDepth = 0.1, depth = 1.0, leastStep = 0.0;
  double degression = 1.0;
  double angle = 0.0;  // degrees; angle of the flank along which the tool is fed
  int springPasses = 0;
  double taper = 0.0;  // length of the tapered ends
  bool hasEntryTaper = false, hasExitTaper = false;
  double slope = 0.0;     // slope of the drive line of a conical thread, r divided by z
  double along = 1.0;     // length of a pass for one mm of the axis along which the pitch is measured
  double lastStep = 0.0;  // depth of the last pass, the allowance for finishing; 0: none

  void run(ProgramMachine& machine, const SourceLocation& location) const;

 private:
  void pass(ProgramMachine& machine, const SourceLocation& location, double at) const;
  double shift(double at) const;  // shift along z at this distance from the drive line
};

}  // namespace handwheel
