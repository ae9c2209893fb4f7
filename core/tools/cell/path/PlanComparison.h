// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PlanOperation.h"

namespace handwheel {

// A path that was planned through the first critical configurations of a list.
struct ComparedPath {
  std::size_t critical = 0;  // Number of critical configurations that it passes through
  bool isOptimised = false;
  Result<PlannedPath> planned = Error{};
  Result<CheckedPath> checked = Error{};  // Set if the path was planned
};

// Plans paths from the first waypoint to the last: without the waypoints between them, with the first of these, with
// the first two and so on. Each path is planned without and with the shortcuts of the settings. He 2008, chapter 6,
// compares a planner alone with critical configurations in the same manner. Failed plans are in the list, too. The list
// is incomplete if cancelled.
std::vector<ComparedPath> comparedPaths(const CellScene& scene, const CellPlans& plans,
                                        std::span<const Waypoint> waypoints, const RouteSettings& settings,
                                        Progress progress = {});

}  // namespace handwheel
