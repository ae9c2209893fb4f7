// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotModel.h"

#include <string>

namespace handwheel {

// Returns the URDF of a robot, from which readUrdf() reads an equal robot. The URDF contains links, joints with their
// limits, shapes and colours. Meant for robots from other sources, such as Denavit-Hartenberg tables.
std::string urdfOf(const RobotModel& robot);

}  // namespace handwheel
