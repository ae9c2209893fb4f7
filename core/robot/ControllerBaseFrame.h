// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotArms.h"

#include <optional>

namespace handwheel {

// Returns the base frame of a robot's controller, in the frame of the robot's base. For a built-in robot the two frames
// are equal. In a description the controller's frame is the link "base" of ROS (REP 199), with the same prefix as
// base_link; it must be fixed to the base of the robot. Returns nothing if the description has no such link.
std::optional<Pose> controllerBaseFrame(const RobotModel& robot, const RobotArm& arm);

}  // namespace handwheel
