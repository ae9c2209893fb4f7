// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/RoutePlanning.h"

#include "planning/planners/Planners.h"

#include <algorithm>
#include <cassert>

namespace handwheel {

namespace {

// Returns a path after it was shortened. SBL comes around obstacles on any side, which shortening cannot change: its
// first path is compared with others.
JointPath shortest(const RobotScene& scene, PlanResult planned, const RouteSettings& settings, const Progress& progress,
                   std::uint64_t& steps) {
  const auto shortenedOf = [&](JointPath path, std::uint64_t seed) {
    return shortened(scene, std::move(path), settings.plan.check, settings.shortcuts, settings.plan.seconds, seed,
                     progress);
  };
  const ArmValues start = planned.path.front(), goal = planned.path.back();
  JointPath best = shortenedOf(std::move(planned.path), settings.plan.seed);
  constexpr std::uint64_t kOthers = 3;
  for (std::uint64_t other = 1; settings.planner == "sbl" && other <= kOthers && !progress.cancelled(); ++other) {
    PlanSettings again = settings.plan;
    again.seed = settings.plan.seed + other * 0x9e3779b9U;
    again.mostMilestones = std::min(again.mostMilestones, 2 * planned.milestones + 100);  // not longer than the first
    PlanResult found = planPath(scene, start, goal, again, settings.planner, progress);
    steps += found.steps;
    if (found.outcome != PlanResult::Outcome::Solved) continue;
    JointPath path = shortenedOf(std::move(found.path), again.seed);
    if (lengthOf(scene, path) < lengthOf(scene, best)) best = std::move(path);
  }
  return best;
}

}  // namespace

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
                             : shortest(scene, std::move(planned), settings, part.part(0.7, 1.0), route.steps));
  }
  return route;
}

}  // namespace handwheel
