// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// Functions that return a robot cell with its robots changed. RobotCellDocument::robotsEdit() makes an edit of the
// result.

// A robot to add: the only one of a cell made by importCell() or cellOf().
struct AddedRobot {
  std::shared_ptr<const RobotCellSnapshot> from;
  std::string name = {};         // Empty: the name in its description
  Pose base = Pose::Identity();  // In the frame of the root
};

// Returns the cell with one more robot, at rest; pairs that its description allows to touch are added. A name that is
// taken gets a number. Costs about as much as reading the description of all robots. Errors: ArmNameUnusable {name};
// Unsupported if there are several to add; ValueOutOfRange of the base; FileTooLarge {"triangles", …}; PlansFull; those
// of readUrdf().
Result<RobotCellSnapshot> withRobotAdded(const RobotCellSnapshot& cell, const AddedRobot& added);

// Returns the cell without one of its robots and its configurations and paths. The bodies that it carries keep their
// poses. Errors: OnlyRobot {name}; those of readUrdf().
Result<RobotCellSnapshot> withRobotRemoved(const RobotCellSnapshot& cell, std::size_t arm);

// Returns the cell with the base of one robot, and the bodies that it carries, moved to another pose. Errors: ArmOnRoot
// {name} for the robot whose base is the root, the origin of the cell; ValueOutOfRange; those of readUrdf().
Result<RobotCellSnapshot> withRobotMoved(const RobotCellSnapshot& cell, std::size_t arm, const Pose& base);

}  // namespace handwheel
