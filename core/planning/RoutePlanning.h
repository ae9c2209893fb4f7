// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/PathShortcuts.h"

#include <string>

namespace handwheel {

// Settings for planning a path through several waypoints.
struct RouteSettings {
  PlanSettings plan;
  std::string planner = "sbl";  // one of planners()
  int shortcuts = 100;          // attempts to shorten each leg; 0: it stays as the planner made it
};

// A path through waypoints, leg by leg.
struct Route {
  PlanResult::Outcome outcome = PlanResult::Outcome::Solved;
  std::vector<JointPath> legs;    // waypoints of each leg, with both ends; on failure those before the failed one
  std::size_t failedLeg = 0;      // from 0; if it is not solved
  RobotScene::Nearest blocked{};  // the collision at a given waypoint
  std::uint64_t steps = 0;        // number of points that were checked
  bool isSolved() const { return outcome == PlanResult::Outcome::Solved; }
};

// Plans through all of these waypoints, at least two, in their order: straight if that is free, otherwise by the
// planner; then each leg is shortened. The waypoints stay. Free between all points (MotionCheck).
Route planRoute(const RobotScene& scene, std::span<const ArmValues> waypoints, const RouteSettings& settings,
                Progress progress = {});

}  // namespace handwheel
