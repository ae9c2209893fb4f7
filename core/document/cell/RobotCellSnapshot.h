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

// The robots of a cell in one model, with the surfaces for their display. The data do not change when the joints move,
// so snapshots and display share them.
struct CellRobot {
  RobotModel model;
  std::vector<RobotArm> arms;  // At least one robot
  std::string description;     // The URDF file as it was read, or a URDF text that was written for all robots
  // One surface per shape of the model, in mm, with coordinates that single precision can represent. Null: the mesh is
  // missing.
  std::vector<std::shared_ptr<const TriangleSoup>> surfaces;
};

// The value of a cell document.
struct RobotCellSnapshot : Snapshot {
  std::shared_ptr<const CellRobot> robot;  // All robots of the cell; never null
  JointValues joints;                      // Joint values within their limits
  std::string source;                      // The file of the first robot, as text in UTF-8
  BodySet bodies;  // All bodies; the pose of a body that no link carries is in the frame of the root
  std::shared_ptr<const CellPlans> plans = std::make_shared<const CellPlans>();  // Never null
  // The findings of verifications, perhaps of a former state of the cell. Never null.
  std::shared_ptr<const PathProofs> proofs = std::make_shared<const PathProofs>();
  // False: the file is of a version that did not list the pairs of links that touch at rest (withRestingPairs()).
  bool areRestingPairsKnown = true;
};

}  // namespace handwheel
