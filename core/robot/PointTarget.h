// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotModel.h"

namespace handwheel {

// A point of a link with its target position, for inverse kinematics.
struct PointTarget {
  std::uint32_t link = kNone;
  Vec3 point = Vec3::Zero();   // in the frame of the link; mm
  Vec3 target = Vec3::Zero();  // in the frame of the root; mm
  std::uint32_t dof = kNone;   // the only degree of freedom that may move; kNone: all may
};

// Returns the distance of the point from its target; mm.
double targetDistance(const RobotModel& robot, const JointValues& values, const PointTarget& pull);

// Solves the inverse kinematics of a point by damped least squares. The result is as near to the target as the given
// number of steps can bring it, and never further away than at the beginning. The error enters the damping (Chan and
// Lawrence 1988; Sugihara 2011), so the motion stays calm if the arm is stretched or folded. Limits are kept: a joint
// that meets its limit stays there and the others continue. The result is finite for every finite input. O(steps ·
// joints), times the number of joints that meet their limits.
JointValues pulled(const RobotModel& robot, const JointValues& values, const PointTarget& pull, int steps = 40);

}  // namespace handwheel
