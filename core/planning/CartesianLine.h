// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/planners/SblPlanner.h"
#include "robot/arm/SerialArm.h"

namespace handwheel {

// Settings for following a straight line with the tool.
struct LineSettings {
  double deviation = 0.05;   // mm: largest deviation of the tool's centre point between two waypoints
  double angle = 1e-3;       // rad: largest deviation of the tool's rotation between two waypoints
  double largestStep = 0.1;  // rad: largest motion of a revolute joint between two waypoints
  // Largest deviation of a joint, between two waypoints, from the value that keeps the tool exactly on the line; rad.
  // For slides 1000 mm count as a radian.
  double jointOff = 5e-4;
};

// Joint values along a line of the tool.
struct FollowedLine {
  JointPath path;        // from the start of the line; includes the end if it was reached
  double reached = 0.0;  // fraction of the line that can be followed; 1: the whole line
  // Estimated largest deviation of each joint from its value on the exact line (LineSettings::jointOff), for each
  // motion between two waypoints; rad, mm.
  std::vector<ArmValues> offs = {};
};

// Finds joint values along a straight line of the tool's centre point. The tool turns uniformly along the line, by the
// shortest rotation. The joint values stay as near to the line as the settings demand, and no joint leaps. The path
// stops if the arm cannot continue, or if it would reach the end in another configuration. The joint values of both
// ends are exact. tool: the tool's centre point in the frame of the arm's tip.
FollowedLine followLine(const SerialArm& arm, const Pose& tool, const ArmValues& from, const ArmValues& to,
                        const LineSettings& settings = {}, Progress progress = {});

}  // namespace handwheel
