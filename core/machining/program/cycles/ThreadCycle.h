// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramMachine.h"

namespace handwheel {

// The passes of a thread (G76): parallel to Z, deeper each time, along one flank.
//
// The depth of pass n is firstDepth·n^(1/degression) below the peaks: degression 1 keeps the depth of each pass, 2 the
// area of its chip. Lengths in mm, of radii. The start must be beside the peaks, by `peak`.
struct ThreadCycle {
  ProfilePoint start{0, 0};  // (r, z), on the drive line
  double endZ = 0.0;
  double pitch = 1.0;
  double peak = 1.0;  // from the drive line to the peaks of the thread
  bool isInside = false;
  double firstDepth = 0.1, depth = 1.0, leastStep = 0.0;
  double degression = 1.0;
  double angle = 0.0;  // degrees; angle of the flank along which the tool is fed
  int springPasses = 0;
  double taper = 0.0;  // length of the tapered ends
  bool hasEntryTaper = false, hasExitTaper = false;
  double slope = 0.0;     // slope of the drive line, r by z: a conical thread
  double along = 1.0;     // mm of the flank for one mm of the axis that the pitch is measured on
  double lastStep = 0.0;  // depth of the last pass: the allowance for finishing; 0: none

  void run(ProgramMachine& machine, const SourceLocation& location) const;

 private:
  void pass(ProgramMachine& machine, const SourceLocation& location, double at) const;
  double shift(double at) const;  // shift along z, at this depth from the drive line
};

}  // namespace handwheel
