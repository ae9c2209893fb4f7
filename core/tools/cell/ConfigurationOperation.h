// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/cell/RobotCellSnapshot.h"
#include "robot/SrdfReader.h"

namespace handwheel {

// The operation "configuration", which edits the plans of a cell. It stores where the robot stands under a name, moves
// it there, removes what is stored; the same for targets, frames, and poses of the tool; removes paths; sets what
// planning goes by.
const Operation& configurationOperation();

// What is wrong with a combination of values, as a clause; empty when they fit together.
std::string problemOfConfigurationValues(const OperationValues& values);

// What the values make of a cell.
struct ChangedCell {
  CellPlans plans;
  JointValues joints;
};

// Errors: PlaceMissing, PathMissing, FrameMissing, FrameStray, BodyError::BodyMissing, those of CellReach.h and
// sceneOf(); BodyError::NameTaken and NameUnusable, ValueOutOfRange.
Result<ChangedCell> changedCell(const OperationValues& values, const RobotCellSnapshot& cell);

// Plans with what an SRDF says: the pairs that may touch, and its states as configurations. Error: ValueOutOfRange.
Result<CellPlans> withSemantics(CellPlans plans, const RobotSemantics& semantics, const RobotCellSnapshot& cell);

}  // namespace handwheel
