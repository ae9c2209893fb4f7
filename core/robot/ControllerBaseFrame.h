// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotArms.h"

#include <optional>

namespace handwheel {

// Returns the base frame of a controller, in the base of its robot. For a built-in robot both are the same; in a
// description it is the link "base" of ROS (REP 199), with the same prefix as its base_link; it must be fixed to the
// base of the robot. None: the description does not define it.
std::optional<Pose> controllerBaseFrame(const RobotModel& robot, const RobotArm& arm);

}  // namespace handwheel
