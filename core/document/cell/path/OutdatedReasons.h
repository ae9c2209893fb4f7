// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellFrames.h"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace handwheel {

struct CellRobot;

// The reasons why a planned path is out of date.
struct OutdatedReasons {
  std::string part = {};                      // The part whose curve the path follows, if the part was moved
  bool isBaseOther = false;                   // True if the robot of the path was moved after the curve was planned
  bool isToolOther = false;                   // True if the curve was planned with another tool centre point
  std::set<std::string> targets = {};         // Targets of the waypoints that the tool does not reach any more
  std::set<std::string> configurations = {};  // Configurations of the waypoints whose joint values have changed
  std::set<std::string> frames = {};  // Frames that the waypoints were read in and that are elsewhere for the tool now

  bool isAny() const {
    return isToolOther || isBaseOther || !part.empty() || !targets.empty() || !configurations.empty() ||
           !frames.empty();
  }
  bool operator==(const OutdatedReasons&) const = default;
};

// Returns the reasons why a path is out of date at present. The other robots have their present joint values. Parts,
// targets, frames and configurations that were removed do not count. O(waypoints · links + bodies).
OutdatedReasons outdatedReasonsOf(const CellRobot& robot, const CellPlacement& cell, const RobotPath& path);

// Returns the pose of a target in the frame of the tool of a robot at these joint values; nothing if the target is
// missing. arm: as in CellPlans::arm.
std::optional<Pose> targetInTool(const CellRobot& robot, const CellPlacement& cell, std::string_view arm,
                                 const JointValues& at, std::string_view target);

// Returns the pose of a frame likewise.
std::optional<Pose> frameInTool(const CellRobot& robot, const CellPlacement& cell, std::string_view arm,
                                const JointValues& at, std::string_view frame);

// Returns the configuration of a waypoint if the configuration no longer has the joint values of the waypoint; null if
// it has them, is missing, or belongs to another robot. arm: the robot of the waypoint, as in CellPlans::arm.
const NamedConfiguration* changedConfiguration(const CellRobot& robot, const CellPlans& plans, std::string_view arm,
                                               const Waypoint& waypoint);

// Returns the plans with a configuration renamed. wanted: the new name, which must be free. Waypoints at the
// configuration, and the ends of paths along curves, get the new name.
CellPlans withConfigurationRenamed(CellPlans plans, const std::string& name, const std::string& wanted);

// Returns the names of the paths with waypoints at a configuration.
std::vector<std::string> pathsThrough(const CellPlans& plans, std::string_view configuration);

// Returns true if two poses are equal up to the precision of programs (1e-3 mm, 1e-3°).
bool isSamePose(const Pose& one, const Pose& other);

}  // namespace handwheel
