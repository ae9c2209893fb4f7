// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// The operation "robot", which edits the robots of a cell. It adds one, removes one, or chooses the one that is planned
// for.
const Operation& robotOperation();

// What is wrong with a combination of values, as a clause; empty when they fit together.
std::string problemOfRobotValues(const OperationValues& values);

// What the values make of a cell. added: the robot that they name; null where they name none. Errors: those of
// RobotChanges.h; ArmMissing.
Result<RobotCellSnapshot> withRobotsChanged(const OperationValues& values, const RobotCellSnapshot& cell,
                                            const std::shared_ptr<const RobotCellSnapshot>& added);

}  // namespace handwheel
