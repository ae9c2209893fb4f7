// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/cell/RobotCellSnapshot.h"
#include "robot/arm/SerialArm.h"

#include <optional>

namespace handwheel {

// Selection of one of the robots of a cell, with its tool and joints.

// Returns the number of the robot with a name as in CellPlans::arm; nothing if the cell has no such robot.
std::optional<std::size_t> armNumber(const CellRobot& robot, std::string_view name);
// Returns the number of the robot that is planned for. It is the first one if the plans name a robot that does not
// exist.
std::size_t activeArmNumber(const CellRobot& robot, const CellPlans& plans);
const RobotArm& activeArm(const CellRobot& robot, const CellPlans& plans);
// Returns true if two names, as in CellPlans::arm, denote the same robot.
bool isSameArm(const CellRobot& robot, std::string_view one, std::string_view other);

// Returns how the controller of a robot couples its second and third joint; none if it does not, or if the robot does
// not come with the program.
std::optional<AxisCoupling> couplingOf(const RobotArm& robot, const SerialArm& arm);

// Returns the tool centre point of a robot in the frame of the link that carries the tool. The result is the identity
// if the name is unknown.
Pose toolOf(const CellRobot& robot, const CellPlans& plans, std::string_view arm);

// Returns the plans with this robot as the one that is planned for. Errors: ArmMissing {name}.
Result<CellPlans> withArmChosen(const CellRobot& robot, CellPlans plans, std::string_view name);

// Returns the degrees of freedom of one robot, in rising order.
std::vector<std::uint32_t> dofsOfArm(const CellRobot& robot, std::size_t arm);
// Returns the joint values with those of one robot replaced. from: the values of all joints, of which those of the
// robot are taken.
JointValues withJointsOf(const CellRobot& robot, std::size_t arm, JointValues joints, const JointValues& from);

// Returns the joint values after a configuration or a waypoint of a robot was applied. The joints of other robots keep
// their values. If the name denotes no robot, nothing changes.
JointValues jointsSetBy(const CellRobot& robot, std::string_view arm, const JointValues& set,
                        const JointValues& present);

}  // namespace handwheel
