// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "machining/program/ProgramSetup.h"
#include "machining/program/ToolPath.h"
#include "machining/target/TargetProfile.h"

namespace handwheel {

// The settings for roughing and finishing a target from a bar. Lengths are in mm.
struct CycleSettings {
  double depth = 1.5;       // depth of a level along r
  double allowance = 0.3;   // material that is left for finishing
  double nose = 0.4;        // nose radius of the roughing and the finishing tool
  double roughFeed = 0.25;  // mm per revolution
  double finishFeed = 0.08;
  double speed = 150.0;       // m/min, surface speed
  double mostSpindle = 2000;  // r/min
  double clearance = 2.0;     // distance between rapid moves and material
  double overrun = 2.0;       // extra cut below the target, for parting off, if the room allows it
  double room = 1e9;          // length of the bar between the target and the chuck
  double drill = 0.0;         // diameter of the hole from which the bore is made; 0: no bore is made
  ProgramPost post;           // decides between M3 and M4
  int roughTool = 1, finishTool = 2, drillTool = 3, boreTool = 4;
};

// Returns the path of the tip that makes the outside of a target from a bar. The tool cuts levels from the bar inward
// and descends into pockets at their right side. It then follows the contour once with the allowance and once without.
// The upper end of the target is z = 0. The path of the nose is computed exactly from lines and arcs, not from sampled
// points (NoseCompensation). Surfaces at the lower end that are as thick as the bar are not cut, so a chuck may hold
// the bar there. Errors: Refused if the nose does not fit, if the target has an undercut, or if the chuck is an
// obstacle.
Result<std::vector<ToolMove>> roughAndFinish(const TargetProfile& target, double barRadius,
                                             const CycleSettings& settings);

}  // namespace handwheel
