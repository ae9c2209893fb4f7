// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellArms.h"
#include "document/cell/CellScene.h"
#include "robot/arm/ArmSolutions.h"

namespace handwheel {

// Reachable poses of the tool centre point of the robot that is planned for. They are in the frame of the root.

// Returns the pose of the tool centre point (CellPlans::tool) at these joint values.
Pose toolPose(const CellRobot& robot, const CellPlans& plans, const JointValues& joints);

// A solution of the inverse kinematics in a cell, with its collision.
struct CellIkSolution {
  ArmSolution arm;
  RobotScene::Nearest
      blocked{};  // Links or bodies that are too close. No link: none, or the solution is beyond the limits

  bool isWithinLimits() const { return !arm.beyond; }
  bool isFree() const { return isWithinLimits() && blocked.link == kNone; }
};

// Returns all solutions for a pose of the tool, in the order of solutionsFor(). Each has its collision, if any, with
// the clearance of the plans.
std::vector<CellIkSolution> ikSolutionsTo(const CellScene& scene, const CellPlans& plans, const Pose& pose,
                                          const ArmValues& near);

// Returns the joint values of the nearest solution that is free. Errors: ToolOutOfReach, ToolBeyondLimits, ToolBlocked.
Result<ArmValues> nearestFree(const CellScene& scene, const CellPlans& plans, const Pose& pose, const ArmValues& near);

// Returns the joint values nearest to the given ones that bring the tool to a pose, without a check of collisions.
// Errors: ToolOutOfReach, ToolBeyondLimits; the errors of SerialArm::of().
Result<JointValues> jointsReaching(const CellRobot& robot, const CellPlans& plans, const Pose& pose,
                                   const JointValues& joints);

}  // namespace handwheel
