// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "document/cell/CellReach.h"

namespace handwheel {

// Poses of the tool, targets and frames in configurationOperation().

// Returns true if the value "go" names a target.
bool goesToTarget(const OperationValues& values, const CellPlans& plans);

// Returns true if the values move the robot to a pose of its tool, which is given or that of a target.
bool movesTool(const OperationValues& values, const CellPlans& plans);

// Returns the pose of the tool that the values determine: the target to go to, or else "at" and "turn", whose defaults
// are those of the present pose. Errors: the errors of poseOfTarget().
Result<Pose> givenPose(const OperationValues& values, const RobotCellSnapshot& cell);

// Returns the joint values for the pose of givenPose(): those of the solution with the number "solution", or else of
// the nearest solution without a collision. Errors: ValueOutOfRange of "solution"; the errors of nearestFree(),
// sceneOf() and givenPose().
Result<JointValues> jointsThere(const OperationValues& values, const RobotCellSnapshot& cell);

// Remove and add targets, or frames, as the values demand. Errors: WaypointMissing, FrameMissing, FrameStray,
// BodyMissing, NameUnusable, WaypointNameTaken; the errors of carriedFrame() and targetInFrame().
Status changeTargets(const OperationValues& values, const RobotCellSnapshot& cell, CellPlans& plans);
Status changeFrames(const OperationValues& values, const RobotCellSnapshot& cell, CellPlans& plans);

}  // namespace handwheel
