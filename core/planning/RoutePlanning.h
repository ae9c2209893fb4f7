// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/PathShortcuts.h"

#include <string>

namespace handwheel {

// Settings for planning a path through several waypoints.
struct RouteSettings {
  PlanSettings plan;
  std::string planner = "sbl";  // id of one of planners()
  int shortcuts = 100;          // number of attempts to shorten each leg; 0: legs are not shortened
};

// A path through waypoints, leg by leg.
struct Route {
  PlanResult::Outcome outcome = PlanResult::Outcome::Solved;
  // Waypoints of each leg, with both ends; after a failure only the legs before the failed one.
  std::vector<JointPath> legs;
  std::size_t failedLeg = 0;      // index of the failed leg, if the route is not solved
  RobotScene::Nearest blocked{};  // the collision at a given waypoint, if it is blocked
  std::uint64_t steps = 0;        // number of points that were checked
  bool isSolved() const { return outcome == PlanResult::Outcome::Solved; }
};

// Plans a path through all waypoints in their order; there must be at least two. A leg is a straight motion if that is
// free; otherwise the planner finds a path for it. Then each leg is shortened. The route contains all waypoints and is
// proven free at all points (MotionCheck).
Route planRoute(const RobotScene& scene, std::span<const ArmValues> waypoints, const RouteSettings& settings,
                Progress progress = {});

}  // namespace handwheel
