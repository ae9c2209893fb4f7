// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/cell/CellReach.h"

namespace handwheel {

// Poses of the tool, targets and frames in configurationOperation().

// Whether "go" names a target.
bool goesToTarget(const OperationValues& values, const CellPlans& plans);

// Whether the values move the robot by a pose of its tool: one that they give, or that of a target.
bool movesTool(const OperationValues& values, const CellPlans& plans);

// The pose of the tool that the values give: that of the target to go to, or "at" and "turn", without which it is that
// where the robot stands. Error: TargetStray.
Result<Pose> givenPose(const OperationValues& values, const RobotCellSnapshot& cell);

// The joints by which the robot gets there: the way that "solution" names, or the nearest that is free. Errors:
// ValueOutOfRange of "solution"; those of nearestFree(), sceneOf() and givenPose().
Result<JointValues> jointsThere(const OperationValues& values, const RobotCellSnapshot& cell);

// Adds or removes a target, or a frame. Errors: PlaceMissing, FrameMissing, FrameStray, BodyMissing, NameUnusable,
// PlaceNameTaken; those of carriedFrame().
Status changeTargets(const OperationValues& values, const RobotCellSnapshot& cell, CellPlans& plans);
Status changeFrames(const OperationValues& values, const RobotCellSnapshot& cell, CellPlans& plans);

}  // namespace handwheel
