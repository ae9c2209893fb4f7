// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// Changes of the robots of a cell: what it would be afterwards. RobotCellDocument::robotsEdit() makes an edit of it.

// A robot to add: that of a cell with one, as importCell() and cellOf() give it.
struct AddedRobot {
  std::shared_ptr<const RobotCellSnapshot> from;
  std::string name = {};         // empty: that of its description
  Pose base = Pose::Identity();  // in the frame of the root
};

// The cell with one robot more, at rest; pairs that its description allows to touch go with it. A name that is taken
// gets a number. Costs about as much as reading the description of all robots. Errors: ArmNameUnusable {name};
// Unsupported where there are several to add; ValueOutOfRange of the base; FileTooLarge {"triangles", …}; PlansFull;
// those of readUrdf().
Result<RobotCellSnapshot> withRobotAdded(const RobotCellSnapshot& cell, const AddedRobot& added);

// The cell without one of its robots: also without its configurations and paths, and what it carries stands where it
// is. Errors: OnlyRobot {name}; those of readUrdf().
Result<RobotCellSnapshot> withRobotRemoved(const RobotCellSnapshot& cell, std::size_t arm);

// The cell with one of its robots, with what it carries, at another place. Errors: ArmOnRoot {name} for the one whose
// base is the root, which all is measured from; ValueOutOfRange; those of readUrdf().
Result<RobotCellSnapshot> withRobotMoved(const RobotCellSnapshot& cell, std::size_t arm, const Pose& base);

}  // namespace handwheel
