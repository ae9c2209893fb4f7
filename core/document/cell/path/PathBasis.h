// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// The inputs on which the verification of a path depends. What it found holds as long as none of this changes. Lengths
// in mm, angles in rad. A value; any thread.
struct PathBasis {
  RobotPath path;
  std::shared_ptr<const CellRobot> robot;
  BodySet bodies;
  JointValues joints;                  // of the whole cell
  std::vector<std::uint32_t> planned;  // degrees of freedom that the path itself sets: where they stand does not count
  std::set<std::pair<std::string, std::string>> allowed;
  Pose tool = Pose::Identity();  // of the robot of the path
  double clearance = 0.0;
  // Of its places, in order: the targets that they were planned to and the frames of these, all without their names.
  std::vector<std::pair<NamedTarget, NamedFrame>> targets;
  std::vector<std::vector<double>> configurations;  // that its places stand for, in order: joints of its robot
};
PathBasis basisOf(const RobotCellSnapshot& cell, const RobotPath& path);

// PathBasis::targets. Targets and frames that are missing are empty ones.
std::vector<std::pair<NamedTarget, NamedFrame>> targetsOf(const CellPlans& plans, const RobotPath& path);

// PathBasis::configurations. One that is missing, or of another robot, has no values.
std::vector<std::vector<double>> configurationsOf(const CellRobot& robot, const CellPlans& plans,
                                                  const RobotPath& path);

// The degrees of freedom that paths of a robot set, by its name as in RobotPath::arm.
std::vector<std::uint32_t> plannedDofs(const CellRobot& robot, std::string_view arm);

// Compares with the cell and the path as they are now. The name of the path, and how it was chosen on a part, do not
// count; nor do names and colours of bodies, and whether they are shown. O(places + bodies).
BasisChange changeSince(const PathBasis& basis, const RobotCellSnapshot& cell, const RobotPath& path);

// Whether two paths are the same places of the same robot, whatever they are called.
bool areSameWay(const RobotPath& one, const RobotPath& other);

}  // namespace handwheel
