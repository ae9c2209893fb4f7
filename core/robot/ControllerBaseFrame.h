// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotArms.h"

#include <optional>

namespace handwheel {

// The base that a controller counts from, in that of its robot. A built-in robot has its own there, a description the
// link "base", as ROS calls it (REP 199), with what its base_link has before its name; it must be fixed to the base of
// the robot. None: the description does not say.
std::optional<Pose> controllerBaseFrame(const RobotModel& robot, const RobotArm& arm);

}  // namespace handwheel
