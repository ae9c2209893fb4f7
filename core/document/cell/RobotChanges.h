// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// Functions that return a robot cell with its robots changed. RobotCellDocument::robotsEdit() makes an edit of the
// result.

// A robot to add to a cell. It must be the only robot of the cell `from`, made by importCell() or cellOf().
struct AddedRobot {
  std::shared_ptr<const RobotCellSnapshot> from;
  std::string name = {};         // Name of the robot; empty: the name in its description
  Pose base = Pose::Identity();  // Pose of the base in the frame of the root
};

// Returns the cell with another robot, at rest, and with the pairs that its description allows to touch. A number is
// added to a name that is taken. The cost is about that of reading the description of all robots. Errors:
// ArmNameUnusable {name}; Unsupported if added.from has several robots; ValueOutOfRange of the base; FileTooLarge
// {"triangles", …}; PlansFull; the errors of readUrdf().
Result<RobotCellSnapshot> withRobotAdded(const RobotCellSnapshot& cell, const AddedRobot& added);

// Returns the cell without one of its robots, and without the configurations and paths of this robot. The bodies that
// the robot carries keep their poses. Errors: OnlyRobot {name}; the errors of readUrdf().
Result<RobotCellSnapshot> withRobotRemoved(const RobotCellSnapshot& cell, std::size_t arm);

// Returns the cell with the base of one robot, and the bodies that it carries, moved to another pose. Errors: ArmOnRoot
// {name} for the robot whose base is the root, the origin of the cell; ValueOutOfRange; the errors of readUrdf().
Result<RobotCellSnapshot> withRobotMoved(const RobotCellSnapshot& cell, std::size_t arm, const Pose& base);

}  // namespace handwheel
