// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/path/PlanComparison.h"

#include <algorithm>
#include <cassert>

namespace handwheel {

std::vector<ComparedPath> comparedPaths(const CellScene& scene, const CellPlans& plans,
                                        std::span<const Waypoint> waypoints, const RouteSettings& settings,
                                        Progress progress) {
  assert(waypoints.size() >= 2);
  const PathCheckSettings check{.clearance = settings.plan.check.clearance,
                                .resolution = std::min(PathCheckSettings().resolution, settings.plan.check.resolution)};
  std::vector<ComparedPath> all;
  const std::size_t between = waypoints.size() - 2;
  const double share = 0.5 / static_cast<double>(between + 1);
  for (std::size_t critical = 0; critical <= between; ++critical) {
    std::vector<Waypoint> some(waypoints.begin(), waypoints.begin() + static_cast<std::ptrdiff_t>(critical) + 1);
    some.push_back(waypoints.back());
    for (const bool isOptimised : {false, true}) {
      if (progress.cancelled()) return all;
      const double done = share * static_cast<double>(all.size());
      RouteSettings own = settings;
      if (!isOptimised) own.shortcuts = 0;
      ComparedPath path{critical, isOptimised};
      path.planned = plannedThrough(scene, plans, some, own, progress.part(done, done + 0.7 * share));
      if (path.planned)
        path.checked =
            checkPath(scene, plans, path.planned->path, check, progress.part(done + 0.7 * share, done + share));
      all.push_back(std::move(path));
    }
  }
  return all;
}

}  // namespace handwheel
