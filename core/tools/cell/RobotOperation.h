// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// Returns the operation "robot", which edits the robots of a cell. It adds a robot, removes one, or chooses the robot
// that is planned for.
const Operation& robotOperation();

// Returns the reason why a combination of values is not allowed, as a clause; empty if it is allowed.
std::string problemOfRobotValues(const OperationValues& values);

// Returns the cell with the operation applied. added: the cell of the robot that the values name; null if they name
// none. Errors: the errors of RobotChanges.h; ArmMissing.
Result<RobotCellSnapshot> withRobotsChanged(const OperationValues& values, const RobotCellSnapshot& cell,
                                            const std::shared_ptr<const RobotCellSnapshot>& added);

}  // namespace handwheel
