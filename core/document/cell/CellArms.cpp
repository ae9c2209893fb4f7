// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellArms.h"

#include "document/cell/CellErrors.h"
#include "robot/dh/DhTable.h"

#include <algorithm>

namespace handwheel {

std::optional<std::size_t> armNumber(const CellRobot& robot, std::string_view name) {
  if (name.empty()) return 0;
  const auto found =
      std::find_if(robot.arms.begin(), robot.arms.end(), [&](const RobotArm& arm) { return arm.name == name; });
  return found == robot.arms.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - robot.arms.begin()));
}

std::size_t activeArmNumber(const CellRobot& robot, const CellPlans& plans) {
  return armNumber(robot, plans.arm).value_or(0);
}

const RobotArm& activeArm(const CellRobot& robot, const CellPlans& plans) {
  return robot.arms[activeArmNumber(robot, plans)];
}

bool isSameArm(const CellRobot& robot, std::string_view one, std::string_view other) {
  const auto first = armNumber(robot, one);
  return first && first == armNumber(robot, other);
}

std::optional<AxisCoupling> couplingOf(const RobotArm& robot, const SerialArm& arm) {
  constexpr Eigen::Index kJoints = 6;  // joints of a whole arm of the library
  const LibraryRobot* const known = libraryRobot(robot.title);
  return known && arm.size() == kJoints ? known->coupling : std::nullopt;
}

Pose toolOf(const CellRobot& robot, const CellPlans& plans, std::string_view arm) {
  const auto number = armNumber(robot, arm);
  if (number == activeArmNumber(robot, plans)) return plans.tool;
  const auto known = number ? plans.otherTools.find(robot.arms[*number].name) : plans.otherTools.end();
  return known == plans.otherTools.end() ? Pose(Pose::Identity()) : known->second;
}

Result<CellPlans> withArmChosen(const CellRobot& robot, CellPlans plans, std::string_view name) {
  const auto number = armNumber(robot, name);
  if (!number) return Error{CellError::ArmMissing, {std::string(name)}, {}, {}};
  if (*number != activeArmNumber(robot, plans)) plans.choose(robot.arms[*number].name, activeArm(robot, plans).name);
  return plans;
}

std::vector<std::uint32_t> dofsOfArm(const CellRobot& robot, std::size_t arm) {
  const std::vector<std::uint32_t> owners = armsOfDofs(robot.model, robot.arms);
  std::vector<std::uint32_t> dofs;
  for (std::uint32_t dof = 0; dof < owners.size(); ++dof) {
    if (owners[dof] == arm) dofs.push_back(dof);
  }
  return dofs;
}

JointValues withJointsOf(const CellRobot& robot, std::size_t arm, JointValues joints, const JointValues& from) {
  for (const std::uint32_t dof : dofsOfArm(robot, arm)) joints[dof] = from[dof];
  return joints;
}

JointValues jointsSetBy(const CellRobot& robot, std::string_view arm, const JointValues& set,
                        const JointValues& present) {
  const auto number = armNumber(robot, arm);
  return number ? withJointsOf(robot, *number, present, set) : present;
}

}  // namespace handwheel
