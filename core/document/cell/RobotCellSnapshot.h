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
  std::vector<RobotArm> arms;  // at least one
  std::string description;     // the URDF file as it was read, or written of all robots
  // Per shape of the model, in mm, coordinates that single precision can hold; null for a mesh that is missing.
  std::vector<std::shared_ptr<const TriangleSoup>> surfaces;
};

// The value of a cell document.
struct RobotCellSnapshot : Snapshot {
  std::shared_ptr<const CellRobot> robot;  // never null; all robots of the cell
  JointValues joints;                      // within their limits
  std::string source;                      // the file that the first robot came from, as text in UTF-8
  BodySet bodies;                          // what stands beside the robots; in the frame of the root
  std::shared_ptr<const CellPlans> plans = std::make_shared<const CellPlans>();  // never null
  // What verifications found, perhaps of a former state of the cell. Never null.
  std::shared_ptr<const PathProofs> proofs = std::make_shared<const PathProofs>();
};

}  // namespace handwheel
