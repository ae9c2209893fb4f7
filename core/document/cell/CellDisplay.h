// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DisplayModel.h"
#include "document/cell/RobotCellSnapshot.h"

#include <string_view>

namespace handwheel {

// Creates the display model of a robot for given joint values. It has one part for each visual shape, or for each
// collision shape of a robot without visual shapes. Parts keep their names and surfaces while the joints move.
DisplayModel displayOf(const CellRobot& robot, const JointValues& joints);

// Creates the display model of the robots and of all bodies, including bodies that the robots carry.
DisplayModel displayOf(const CellRobot& robot, const JointValues& joints, const BodySet& bodies);

// Returns the link that a part belongs to; kNone for an unknown part.
std::uint32_t linkOfPart(const CellRobot& robot, std::string_view part);

}  // namespace handwheel
