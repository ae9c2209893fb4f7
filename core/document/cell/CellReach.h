// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellArms.h"
#include "document/cell/CellScene.h"
#include "robot/arm/ArmSolutions.h"

namespace handwheel {

// Reachable poses of the tool's centre point of the current robot of a cell. In the frame of the root.

// The pose of the tool's centre point (CellPlans::tool) where the joints stand.
Pose toolPose(const CellRobot& robot, const CellPlans& plans, const JointValues& joints);

// A solution of the inverse kinematics in a cell: a way in which the robot brings its tool somewhere.
struct CellIkSolution {
  ArmSolution arm;
  RobotScene::Nearest blocked{};  // what is too near there; no link: nothing, or it is beyond the limits

  bool isWithinLimits() const { return !arm.beyond; }
  bool isFree() const { return isWithinLimits() && blocked.link == kNone; }
};

// All solutions for a pose of the tool, as solutionsFor() orders them, and what collides there, with the clearance of
// the plans.
std::vector<CellIkSolution> ikSolutionsTo(const CellScene& scene, const CellPlans& plans, const Pose& pose,
                                          const ArmValues& near);

// The joint values of the nearest solution that is free. Errors: ToolOutOfReach, ToolBeyondLimits, ToolBlocked.
Result<ArmValues> nearestFree(const CellScene& scene, const CellPlans& plans, const Pose& pose, const ArmValues& near);

// Where nothing is asked about collisions: the joints that bring the tool to a pose, the nearest to those given.
// Errors: ToolOutOfReach, ToolBeyondLimits; those of SerialArm::of().
Result<JointValues> jointsReaching(const CellRobot& robot, const CellPlans& plans, const Pose& pose,
                                   const JointValues& joints);

}  // namespace handwheel
