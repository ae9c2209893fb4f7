// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellReach.h"

#include "base/NumberText.h"
#include "document/cell/CellErrors.h"
#include "robot/Kinematics.h"

#include <algorithm>

namespace handwheel {

namespace {

std::vector<std::string> placeOf(const Pose& pose) {
  std::vector<std::string> texts;
  for (const double number : pose.translation()) texts.push_back(roundedText(number, 6));
  return texts;
}

Error outOfReach(const Pose& pose) {
  return {CellError::ToolOutOfReach, placeOf(pose), {}, {}};
}

Error beyondLimits(const Pose& pose, const std::string& joint) {
  std::vector<std::string> arguments = placeOf(pose);
  arguments.push_back(joint);
  return {CellError::ToolBeyondLimits, std::move(arguments), {}, {}};
}

}  // namespace

Pose toolPose(const CellRobot& robot, const CellPlans& plans, const JointValues& joints) {
  return linkPoses(robot.model, joints)[activeArm(robot, plans).flange] * plans.tool;
}

std::vector<CellIkSolution> ikSolutionsTo(const CellScene& scene, const CellPlans& plans, const Pose& pose,
                                          const ArmValues& near) {
  MotionCheckSettings check;
  check.clearance = plans.clearance;
  std::vector<CellIkSolution> ways;
  for (ArmSolution& solution : solutionsFor(scene.arm.withTool(plans.tool), pose, near)) {
    CellIkSolution way{std::move(solution)};
    if (way.isWithinLimits()) way.blocked = blockerAt(scene.scene, way.arm.values, check);
    ways.push_back(std::move(way));
  }
  return ways;
}

Result<ArmValues> nearestFree(const CellScene& scene, const CellPlans& plans, const Pose& pose, const ArmValues& near) {
  const std::vector<CellIkSolution> ways = ikSolutionsTo(scene, plans, pose, near);
  if (ways.empty()) return outOfReach(pose);
  const auto found = std::find_if(ways.begin(), ways.end(), [](const CellIkSolution& way) { return way.isFree(); });
  if (found != ways.end()) return found->arm.values;
  const CellIkSolution& nearest = ways.front();
  if (nearest.arm.beyond) {
    const auto dof = scene.dofs[static_cast<std::size_t>(*nearest.arm.beyond)];
    return beyondLimits(pose, scene.robot->model.jointOfDof(dof).name);
  }
  const auto [link, other] = scene.namesOf(nearest.blocked);
  std::vector<std::string> arguments = placeOf(pose);
  arguments.insert(arguments.end(), {link, other});
  return Error{CellError::ToolBlocked, std::move(arguments), {}, {}};
}

Result<JointValues> jointsReaching(const CellRobot& robot, const CellPlans& plans, const Pose& pose,
                                   const JointValues& joints) {
  const RobotModel& model = robot.model;
  const auto arm = SerialArm::of(model, model.root, activeArm(robot, plans).flange);
  if (!arm) return arm.error();
  ArmValues near(static_cast<Eigen::Index>(arm->dofs.size()));
  for (std::size_t i = 0; i < arm->dofs.size(); ++i) near[static_cast<Eigen::Index>(i)] = joints[arm->dofs[i]];
  const std::vector<ArmSolution> found = solutionsFor(arm->arm.withTool(plans.tool), pose, near);
  if (found.empty()) return outOfReach(pose);
  const ArmSolution& nearest = found.front();
  if (nearest.beyond)
    return beyondLimits(pose, model.jointOfDof(arm->dofs[static_cast<std::size_t>(*nearest.beyond)]).name);
  JointValues moved = joints;
  for (std::size_t i = 0; i < arm->dofs.size(); ++i) moved[arm->dofs[i]] = nearest.values[static_cast<Eigen::Index>(i)];
  return moved;
}

}  // namespace handwheel
