// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/cell/CellReach.h"

namespace handwheel {

// Poses of the tool, targets and frames in configurationOperation().

// Returns true if "go" names a target.
bool goesToTarget(const OperationValues& values, const CellPlans& plans);

// Returns true if the values move the robot to a pose of its tool, either given or that of a target.
bool movesTool(const OperationValues& values, const CellPlans& plans);

// Returns the pose of the tool that the values give: the target to go to, or "at" and "turn", both by default those of
// the present pose. Error: TargetStray.
Result<Pose> givenPose(const OperationValues& values, const RobotCellSnapshot& cell);

// Returns the joint values for that pose: of the solution that "solution" names, or of the nearest free one. Errors:
// ValueOutOfRange of "solution"; those of nearestFree(), sceneOf() and givenPose().
Result<JointValues> jointsThere(const OperationValues& values, const RobotCellSnapshot& cell);

// Add or remove a target, or a frame. Errors: WaypointMissing, FrameMissing, FrameStray, BodyMissing, NameUnusable,
// WaypointNameTaken; those of carriedFrame().
Status changeTargets(const OperationValues& values, const RobotCellSnapshot& cell, CellPlans& plans);
Status changeFrames(const OperationValues& values, const RobotCellSnapshot& cell, CellPlans& plans);

}  // namespace handwheel
