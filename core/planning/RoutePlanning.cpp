// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/RoutePlanning.h"

#include "planning/planners/Planners.h"

#include <cassert>

namespace handwheel {

Route planRoute(const RobotScene& scene, std::span<const ArmValues> waypoints, const RouteSettings& settings,
                Progress progress) {
  assert(waypoints.size() >= 2);
  Route route;
  const double share = 1.0 / static_cast<double>(waypoints.size() - 1);
  for (std::size_t i = 1; i < waypoints.size(); ++i) {
    const double done = share * static_cast<double>(i - 1);
    const Progress part = progress.part(done, done + share);
    MotionCheck direct(scene, waypoints[i - 1], waypoints[i], settings.plan.check);
    const bool isWithin = scene.isWithinLimits(waypoints[i - 1]) && scene.isWithinLimits(waypoints[i]);
    if (isWithin && direct.run(part) == MotionCheck::State::Free) {
      route.steps += direct.steps();
      route.legs.push_back({waypoints[i - 1], waypoints[i]});
      continue;
    }
    PlanResult planned =
        planPath(scene, waypoints[i - 1], waypoints[i], settings.plan, settings.planner, part.part(0.0, 0.7));
    route.steps += planned.steps;
    if (planned.outcome != PlanResult::Outcome::Solved) {
      route.outcome = planned.outcome;
      route.failedLeg = i - 1;
      route.blocked = planned.blocked;
      return route;
    }
    route.legs.push_back(settings.shortcuts == 0
                             ? std::move(planned.path)
                             : shortened(scene, std::move(planned.path), settings.plan.check, settings.shortcuts,
                                         settings.plan.seconds, settings.plan.seed, part.part(0.7, 1.0)));
  }
  return route;
}

}  // namespace handwheel
