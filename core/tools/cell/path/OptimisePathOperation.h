// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PlanOperation.h"

namespace handwheel {

// Returns the operation "optimise-path", which minimises the duration of a path. Its critical waypoints are visited in
// the order, and reached in the configurations, that take the least time.
const Operation& optimisePathOperation();

// Options of the optimisation of a path.
struct OptimisationSettings {
  RouteSettings route;         // Its time limit is for one motion
  bool mayReorder = true;      // False: the waypoints keep their order
  bool mayReconfigure = true;  // False: the joint values at each waypoint stay
  double seconds = 30.0;       // Time limit of the search
};
OptimisationSettings optimisationSettingsOf(const OperationValues& values, const CellPlans& plans,
                                            const RobotPath& path);

// Result of the optimisation of a path.
struct OptimisedPath {
  PlannedPath planned;             // The original path if nothing is quicker
  double before = 0.0;             // s, duration of the original path, with a stop at each waypoint
  double after = 0.0;              // s, duration of the new path, likewise
  std::vector<std::size_t> order;  // Former indices of its critical waypoints, from 0
  std::size_t reconfigured = 0;    // Number of waypoints that are reached with other joint values
  bool isChanged = false;
};

// Replaces a path by one that visits its critical waypoints in the order and the configurations of the arm that take
// the least time, and plans each motion. The configurations are those of the closed-form inverse kinematics for the
// same pose of the tool. The first and the last waypoint stay as they are, and a waypoint at the end of a straight line
// stays behind the one at its beginning. Waypoints that are not critical are left out, as when a path is planned again.
// A path that is not proven to be free of collisions is replaced even by a slower one. Errors: those of
// plannedThrough() and checkPath().
Result<OptimisedPath> optimisedPath(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const OptimisationSettings& settings, Progress progress = {});

}  // namespace handwheel
