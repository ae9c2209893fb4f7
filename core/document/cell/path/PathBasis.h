// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// The inputs on which the verification of a path depends. Its findings are valid while none of these inputs changes.
// Lengths are in mm, angles in rad. The type is a value, which may be used on any thread.
struct PathBasis {
  RobotPath path;
  std::shared_ptr<const CellRobot> robot;
  BodySet bodies;
  JointValues joints;                  // Joint values of the whole cell
  std::vector<std::uint32_t> planned;  // Degrees of freedom that the path sets; their present values do not count
  std::set<std::pair<std::string, std::string>> allowed;
  Pose tool = Pose::Identity();  // Tool centre point of the path's robot
  double clearance = 0.0;
  // Targets that the waypoints were planned to, with their frames, and frames that they were read in, in the order of
  // the waypoints. Their names are omitted.
  std::vector<std::pair<NamedTarget, NamedFrame>> targets;
  std::vector<std::vector<double>>
      configurations;       // Joint values of the path's robot in the configurations of the waypoints, in order
  AssumedRates rates = {};  // Times depend on these
};
PathBasis basisOf(const RobotCellSnapshot& cell, const RobotPath& path);

// Returns the value of PathBasis::targets. Missing targets and frames are replaced by empty ones.
std::vector<std::pair<NamedTarget, NamedFrame>> targetsOf(const CellPlans& plans, const RobotPath& path);

// Returns the value of PathBasis::configurations. A configuration that is missing or belongs to another robot has no
// values.
std::vector<std::vector<double>> configurationsOf(const CellRobot& robot, const CellPlans& plans,
                                                  const RobotPath& path);

// Returns the degrees of freedom that paths of a robot set. arm: the name of the robot, as in RobotPath::arm.
std::vector<std::uint32_t> plannedDofs(const CellRobot& robot, std::string_view arm);

// Returns the first change of the inputs since the verification. The name of the path, and how its curve was chosen on
// a part, do not count, nor do names, colours and visibility of bodies. O(waypoints + bodies).
BasisChange changeSince(const PathBasis& basis, const RobotCellSnapshot& cell, const RobotPath& path);

// Returns true if two paths have the same robot, waypoints and RobotPath::bases, whatever their names.
bool haveSameWaypoints(const RobotPath& one, const RobotPath& other);

}  // namespace handwheel
