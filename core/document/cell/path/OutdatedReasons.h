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
  std::string part = {};               // that it leads along, where that stands elsewhere now
  bool isBaseOther = false;            // its robot stands elsewhere than when its curve was planned
  bool isToolOther = false;            // its curve was planned with another centre point of the tool
  std::set<std::string> targets = {};  // that places of it were planned to, where the tool does not come to them now
  std::set<std::string> configurations = {};  // that places of it stand for, and that are other joint values now

  bool isAny() const {
    return isToolOther || isBaseOther || !part.empty() || !targets.empty() || !configurations.empty();
  }
  bool operator==(const OutdatedReasons&) const = default;
};

// The reasons for a path now, with the other robots where they are. What does not exist any more does not count.
// O(places · links + bodies).
OutdatedReasons outdatedReasonsOf(const CellRobot& robot, const CellPlacement& cell, const RobotPath& path);

// Where a target is for the tool of this robot (CellPlans::arm) at these joint values of it; none where it is missing.
std::optional<Pose> targetInTool(const CellRobot& robot, const CellPlacement& cell, std::string_view arm,
                                 const JointValues& at, std::string_view target);

// The configuration that a place of a path of this robot (CellPlans::arm) stands for, if it is other joint values now;
// null also where it is missing, or of another robot.
const NamedConfiguration* changedConfiguration(const CellRobot& robot, const CellPlans& plans, std::string_view arm,
                                               const Waypoint& place);

// The plans with another name for a configuration, which must be free, also of the places of paths that stand for it
// and of the ends of those along curves.
CellPlans withConfigurationRenamed(CellPlans plans, const std::string& name, const std::string& wanted);

// The names of the paths with places that stand for a configuration.
std::vector<std::string> pathsThrough(const CellPlans& plans, std::string_view configuration);

// Whether two poses are the same for programs, which are read back as exactly: 1e-3 mm, 1e-3°.
bool isSamePlace(const Pose& one, const Pose& other);

}  // namespace handwheel
