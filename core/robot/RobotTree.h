// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "robot/RobotModel.h"

#include <span>
#include <string>
#include <vector>

namespace handwheel {

// A mimic joint of a description, which repeats another joint's motion. Its position is multiplier · position of the
// leader + offset, in metres and radians.
struct MimicJoint {
  std::uint32_t joint;
  std::string leader;
  double multiplier, offset;
};

// The positions of links and joints in a description, for errors.
struct RobotInputPositions {
  std::vector<InputPosition> links, joints;
};

// Builds the kinematic tree of a robot from its links and joints. Resolves the mimic joints, and determines the degrees
// of freedom, the parent joint of each link, the root and the order. The links must form one tree. positions: the
// positions of the links and joints in the description. O((links + joints) log joints). Errors: ElementMalformed,
// ReferenceMissing.
Status buildKinematicTree(RobotModel& robot, std::span<const MimicJoint> following,
                          const RobotInputPositions& positions);

}  // namespace handwheel
