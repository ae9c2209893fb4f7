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
  std::string part = {};                      // The part whose curve it follows, if it was moved
  bool isBaseOther = false;                   // True if its robot was moved after its curve was planned
  bool isToolOther = false;                   // True if its curve was planned with another tool centre point
  std::set<std::string> targets = {};         // Targets of its waypoints that the tool does not reach any more
  std::set<std::string> configurations = {};  // Configurations of its waypoints whose joint values have changed

  bool isAny() const {
    return isToolOther || isBaseOther || !part.empty() || !targets.empty() || !configurations.empty();
  }
  bool operator==(const OutdatedReasons&) const = default;
};

// Returns the reasons for a path at present, with the other robots at their present joint values. Parts, targets and
// configurations that were removed do not count. O(waypoints · links + bodies).
OutdatedReasons outdatedReasonsOf(const CellRobot& robot, const CellPlacement& cell, const RobotPath& path);

// Returns the pose of a target in the frame of the tool of this robot (CellPlans::arm) at these joint values; nothing
// if the target is missing.
std::optional<Pose> targetInTool(const CellRobot& robot, const CellPlacement& cell, std::string_view arm,
                                 const JointValues& at, std::string_view target);

// Returns the configuration of a waypoint of this robot (CellPlans::arm) if its joint values have changed; null also if
// it is missing, or of another robot.
const NamedConfiguration* changedConfiguration(const CellRobot& robot, const CellPlans& plans, std::string_view arm,
                                               const Waypoint& waypoint);

// Returns the plans with another name for a configuration, which must be free. Waypoints at it, and the ends of paths
// along curves, follow the new name.
CellPlans withConfigurationRenamed(CellPlans plans, const std::string& name, const std::string& wanted);

// Returns the names of the paths with waypoints at a configuration.
std::vector<std::string> pathsThrough(const CellPlans& plans, std::string_view configuration);

// Returns true if two poses are equal up to the precision of programs: 1e-3 mm, 1e-3°.
bool isSamePose(const Pose& one, const Pose& other);

}  // namespace handwheel
