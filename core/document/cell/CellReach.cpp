// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellReach.h"

#include "base/NumberText.h"
#include "document/cell/CellErrors.h"
#include "robot/Kinematics.h"

#include <algorithm>

namespace handwheel {

namespace {

std::vector<std::string> positionTexts(const Pose& pose) {
  std::vector<std::string> texts;
  for (const double number : pose.translation()) texts.push_back(roundedText(number, 6));
  return texts;
}

Error outOfReach(const Pose& pose) {
  return {CellError::ToolOutOfReach, positionTexts(pose), {}, {}};
}

Error beyondLimits(const Pose& pose, const std::string& joint) {
  std::vector<std::string> arguments = positionTexts(pose);
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
  std::vector<CellIkSolution> solutions;
  for (ArmSolution& solution : solutionsFor(scene.arm.withTool(plans.tool), pose, near)) {
    CellIkSolution found{std::move(solution)};
    if (found.isWithinLimits()) found.blocked = blockerAt(scene.scene, found.arm.values, check);
    solutions.push_back(std::move(found));
  }
  return solutions;
}

Result<ArmValues> nearestFree(const CellScene& scene, const CellPlans& plans, const Pose& pose, const ArmValues& near) {
  const std::vector<CellIkSolution> solutions = ikSolutionsTo(scene, plans, pose, near);
  if (solutions.empty()) return outOfReach(pose);
  const auto found = std::find_if(solutions.begin(), solutions.end(),
                                  [](const CellIkSolution& solution) { return solution.isFree(); });
  if (found != solutions.end()) return found->arm.values;
  const CellIkSolution& nearest = solutions.front();
  if (nearest.arm.beyond) {
    const auto dof = scene.dofs[static_cast<std::size_t>(*nearest.arm.beyond)];
    return beyondLimits(pose, scene.robot->model.jointOfDof(dof).name);
  }
  const auto [link, other] = scene.namesOf(nearest.blocked);
  std::vector<std::string> arguments = positionTexts(pose);
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
  const std::vector<ArmSolution> found = solutionsFor(
      arm->arm.withTool(plans.tool).withCoupling(couplingOf(activeArm(robot, plans), arm->arm)), pose, near);
  if (found.empty()) return outOfReach(pose);
  const ArmSolution& nearest = found.front();
  if (nearest.beyond)
    return beyondLimits(pose, model.jointOfDof(arm->dofs[static_cast<std::size_t>(*nearest.beyond)]).name);
  JointValues moved = joints;
  for (std::size_t i = 0; i < arm->dofs.size(); ++i) moved[arm->dofs[i]] = nearest.values[static_cast<Eigen::Index>(i)];
  return moved;
}

}  // namespace handwheel
