// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// Returns the operation "robot", which edits the robots of a cell. It adds one, removes one, or chooses the one that is
// planned for.
const Operation& robotOperation();

// Returns the fault of a combination of values, as a clause; empty if they fit together.
std::string problemOfRobotValues(const OperationValues& values);

// Returns the cell with the operation applied. added: the robot that the values name; null if they name none. Errors:
// those of RobotChanges.h; ArmMissing.
Result<RobotCellSnapshot> withRobotsChanged(const OperationValues& values, const RobotCellSnapshot& cell,
                                            const std::shared_ptr<const RobotCellSnapshot>& added);

}  // namespace handwheel
