// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Snapshot.h"
#include "document/cell/PathProof.h"
#include "mesh/structure/TriangleSoup.h"
#include "robot/RobotArms.h"
#include "robot/program/RobotPath.h"
#include "scene/BodySet.h"

namespace handwheel {

// The robots of a cell in one model, with the surfaces for their display. They do not change when the joints move, so
// snapshots and display share them.
struct CellRobot {
  RobotModel model;
  std::vector<RobotArm> arms;  // At least one
  std::string description;     // The URDF file as it was read, or one written for all robots
  // One per shape of the model, in mm, with coordinates that single precision can hold; null for a missing mesh.
  std::vector<std::shared_ptr<const TriangleSoup>> surfaces;
};

// The value of a cell document.
struct RobotCellSnapshot : Snapshot {
  std::shared_ptr<const CellRobot> robot;  // All robots of the cell; never null
  JointValues joints;                      // Within their limits
  std::string source;                      // The file of the first robot, as text in UTF-8
  BodySet bodies;                          // Bodies beside and on the robots; in the frame of the root
  std::shared_ptr<const CellPlans> plans = std::make_shared<const CellPlans>();  // Never null
  // The findings of verifications, perhaps for a former state of the cell. Never null.
  std::shared_ptr<const PathProofs> proofs = std::make_shared<const PathProofs>();
};

}  // namespace handwheel
