// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/PathShortcuts.h"

#include <string>

namespace handwheel {

// How a path through several places is planned.
struct RouteSettings {
  PlanSettings plan;
  std::string planner = "sbl";  // one of planners()
  int shortcuts = 100;          // attempts to make each leg shorter; 0: it stays as the planner made it
};

// A path through places, leg by leg.
struct Route {
  PlanResult::Outcome outcome = PlanResult::Outcome::Solved;
  std::vector<JointPath> legs;    // of each its places, with both ends; those before the one that failed
  std::size_t failedLeg = 0;      // from 0; when it is not solved
  RobotScene::Nearest blocked{};  // at the place that is in collision
  std::uint64_t steps = 0;        // points that were looked at
  bool isSolved() const { return outcome == PlanResult::Outcome::Solved; }
};

// Plans through all of these places, at least two, in their order: straight where that is free, else by the planner;
// then each leg is made shorter. The places stay. Free between all points (MotionCheck).
Route planRoute(const RobotScene& scene, std::span<const ArmValues> places, const RouteSettings& settings,
                Progress progress = {});

}  // namespace handwheel
