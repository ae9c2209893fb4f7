// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PlanOperation.h"

namespace handwheel {

// The operation "optimise-path", which minimises the duration of a path. Its critical places are visited in the order,
// and reached in the configurations, that take the least time.
const Operation& optimisePathOperation();

// How a path is optimised.
struct OptimisationSettings {
  RouteSettings route;         // its time limit is for one motion
  bool mayReorder = true;      // else the places keep their order
  bool mayReconfigure = true;  // else the joints at each place stay as they are
  double seconds = 30.0;       // after which nothing better is looked for
};
OptimisationSettings optimisationSettingsOf(const OperationValues& values, const CellPlans& plans,
                                            const RobotPath& path);

// What became of a path.
struct OptimisedPath {
  PlannedPath planned;             // that as it was, where nothing is quicker
  double before = 0.0;             // s, of the path as it was,
  double after = 0.0;              // and as it is; with a stop at each place
  std::vector<std::size_t> order;  // of its critical places, by their numbers before, from 0
  std::size_t reconfigured = 0;    // places that are reached with other joint values
  bool isChanged = false;
};

// Visits the critical places of a path in the order, and in those of the ways in which the arm reaches each (by the
// closed form, with the same pose of the tool), that take the least time, and plans each motion. The first and the last
// place stay as they are, and places that straight lines lead to stay behind the place that the line begins at. Places
// that are not critical are left out, as when a path is planned again. A path that is not proven free is replaced
// also by one that takes longer. Errors: those of plannedThrough() and checkPath().
Result<OptimisedPath> optimisedPath(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const OptimisationSettings& settings, Progress progress = {});

}  // namespace handwheel
