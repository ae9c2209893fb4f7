// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/planners/SblPlanner.h"
#include "robot/arm/SerialArm.h"

namespace handwheel {

// Settings of following a straight line of the tool.
struct LineSettings {
  double deviation = 0.05;   // mm: largest deviation of the tool's centre point between two waypoints
  double angle = 1e-3;       // rad: largest deviation of the tool's rotation there
  double largestStep = 0.1;  // rad of a joint from one waypoint to the next
  double jointOff = 5e-4;    // largest deviation of a joint there, rad; for slides 1000 mm count as a radian
};

// Joint values along a line.
struct FollowedLine {
  JointPath path;        // from its start; includes its end if that was reached
  double reached = 0.0;  // share of the line that can be followed; 1: all of it
  // Largest deviation of each joint from the line in each motion between two waypoints; rad, mm.
  std::vector<ArmValues> offs = {};
};

// Follows the straight line of the tool's centre point between two poses; its rotation changes by the shortest turn and
// in proportion. The joint values are as near to the line as the settings ask for, without a leap of any joint. The
// path stops if the arm cannot continue, or reaches the end in another configuration. tool: centre point in the arm's
// tip. Both ends are exact.
FollowedLine followLine(const SerialArm& arm, const Pose& tool, const ArmValues& from, const ArmValues& to,
                        const LineSettings& settings = {}, Progress progress = {});

}  // namespace handwheel
