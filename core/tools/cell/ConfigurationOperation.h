// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/cell/RobotCellSnapshot.h"
#include "robot/SrdfReader.h"

namespace handwheel {

// Returns the operation "configuration", which edits the plans of a cell. It stores the present configuration under a
// name, moves the robot to a stored one, and removes one. It also edits targets, frames and poses of the tool, removes
// paths, and sets the options of planning.
const Operation& configurationOperation();

// Returns the reason why a combination of values is not allowed, as a clause; empty if it is allowed.
std::string problemOfConfigurationValues(const OperationValues& values);

// The plans and joints of a cell after the operation.
struct ChangedCell {
  CellPlans plans;
  JointValues joints;
};

// Applies the operation. Errors: WaypointMissing, PathMissing, FrameMissing, FrameStray, BodyError::BodyMissing, the
// errors of CellReach.h and sceneOf(); BodyError::NameTaken and NameUnusable, ValueOutOfRange.
Result<ChangedCell> changedCell(const OperationValues& values, const RobotCellSnapshot& cell);

// Returns the plans with the contents of an SRDF: pairs that may touch, and its states as configurations. Errors:
// ValueOutOfRange.
Result<CellPlans> withSemantics(CellPlans plans, const RobotSemantics& semantics, const RobotCellSnapshot& cell);

}  // namespace handwheel
