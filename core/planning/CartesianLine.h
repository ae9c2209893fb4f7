// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/planners/SblPlanner.h"
#include "robot/arm/SerialArm.h"

namespace handwheel {

// Settings of following a straight line of the tool.
struct LineSettings {
  double deviation = 0.05;   // mm that the tool's centre point may be off between two places
  double angle = 1e-3;       // rad that the tool may be turned off there
  double largestStep = 0.1;  // rad of a joint from one place to the next
  double jointOff =
      5e-4;  // rad, of slides 1000 mm to a radian: how far a joint may be there from where the line has it
};

// Joint values along a line.
struct FollowedLine {
  JointPath path;        // from its start; with its end where it was reached
  double reached = 0.0;  // share of the line that can be followed; 1: all of it
  // Of each motion between two places: how far each joint may be from where the line itself has it; rad, mm.
  std::vector<ArmValues> offs = {};
};

// Follows the straight line of the tool's centre point between two places, its turn changing by the shortest way and in
// proportion: joint values as near to the line as the settings ask for, without a leap of any joint. Where the arm
// cannot go on, or gets to the end with other joint values (in another configuration), it stops. tool: of the centre
// point in the arm's tip. Both ends are exact.
FollowedLine followLine(const SerialArm& arm, const Pose& tool, const ArmValues& from, const ArmValues& to,
                        const LineSettings& settings = {}, Progress progress = {});

}  // namespace handwheel
