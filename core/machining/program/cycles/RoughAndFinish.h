// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "machining/program/ToolPath.h"
#include "machining/target/TargetProfile.h"

namespace handwheel {

// Settings of roughing and finishing a target from a bar. Lengths in mm.
struct CycleSettings {
  double depth = 1.5;       // depth of a level, on the radius
  double allowance = 0.3;   // left for finishing
  double nose = 0.4;        // radius of both tools
  double roughFeed = 0.25;  // mm per revolution
  double finishFeed = 0.08;
  double speed = 150.0;       // m/min, surface speed
  double mostSpindle = 2000;  // r/min
  double clearance = 2.0;     // between moves and material
  double overrun = 2.0;       // extra cut beyond the lower end of the target, for parting off, if the room allows it
  double room = 1e9;          // length of the bar below the target; the chuck is beyond it
  double drill = 0.0;         // diameter of a hole that is bored to the bore of the target; 0: the bore is left
  int roughTool = 1, finishTool = 2, drillTool = 3, boreTool = 4;
};

// Returns the path of the tip that makes the outside of a target from a bar: levels from the bar inward, pockets by
// descending at their right side; once along the contour with the allowance, then along the contour itself. The upper
// end of the target is z = 0. The path of the nose is computed from lines and arcs, without samples (NoseCompensation).
// Surfaces as thick as the bar at the lower end are not cut, so a chuck may hold it there. Errors: Refused, if the nose
// does not fit, the target has an undercut, or the chuck is in the way.
Result<std::vector<ToolMove>> roughAndFinish(const TargetProfile& target, double barRadius,
                                             const CycleSettings& settings);

}  // namespace handwheel
