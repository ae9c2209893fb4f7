// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PlanOperation.h"

namespace handwheel {

// A path through some of the critical configurations, optionally shortened.
struct ComparedPath {
  std::size_t critical = 0;  // Number of critical configurations, the first ones
  bool isOptimised = false;
  Result<PlannedPath> planned = Error{};
  Result<CheckedPath> checked = Error{};  // Set if the path was planned
};

// Plans from the first of these waypoints to the last: without those between, with the first of them, with the first
// two and so on, each without and with the shortcuts of the settings (He 2008, chapter 6: a planner alone, and with
// critical configurations). Failed plans are in the list, too. Incomplete if cancelled.
std::vector<ComparedPath> comparedPaths(const CellScene& scene, const CellPlans& plans,
                                        std::span<const Waypoint> waypoints, const RouteSettings& settings,
                                        Progress progress = {});

}  // namespace handwheel
