// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/cell/RobotCellSnapshot.h"

#include <optional>

namespace handwheel {

// Selection of one of the robots of a cell, and what belongs to it.

// The number of the robot that a name of CellPlans::arm means; none: the cell has no such robot.
std::optional<std::size_t> armNumber(const CellRobot& robot, std::string_view name);
// That of the robot that is planned for. Plans that name a robot that is not there are for the first one.
std::size_t activeArmNumber(const CellRobot& robot, const CellPlans& plans);
const RobotArm& activeArm(const CellRobot& robot, const CellPlans& plans);
// Whether two names of CellPlans::arm mean the same robot.
bool isSameArm(const CellRobot& robot, std::string_view one, std::string_view other);

// The tool's centre point of a robot, in the link that carries its tool; the link itself for a name that means none.
Pose toolOf(const CellRobot& robot, const CellPlans& plans, std::string_view arm);

// The plans with this robot as the one that is planned for. Error: ArmMissing {name}.
Result<CellPlans> withArmChosen(const CellRobot& robot, CellPlans plans, std::string_view name);

// The degrees of freedom of one robot, in order.
std::vector<std::uint32_t> dofsOfArm(const CellRobot& robot, std::size_t arm);
// Joint values with those of one robot from others.
JointValues withJointsOf(const CellRobot& robot, std::size_t arm, JointValues joints, const JointValues& from);

// The joint values that a configuration or a place of a path of this robot sets: those of other robots stay as they
// are. A name that means no robot: nothing moves.
JointValues jointsSetBy(const CellRobot& robot, std::string_view arm, const JointValues& set,
                        const JointValues& present);

}  // namespace handwheel
