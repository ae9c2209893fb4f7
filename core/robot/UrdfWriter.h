// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/RobotModel.h"

#include <string>

namespace handwheel {

// Writes a robot as a URDF that readUrdf() reads as the same. It has links, joints with their limits, shapes and
// colours. For robots from other sources, such as Denavit-Hartenberg tables.
std::string urdfOf(const RobotModel& robot);

}  // namespace handwheel
