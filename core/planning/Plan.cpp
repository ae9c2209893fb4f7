// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/Plan.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

PlanResult checkedEnds(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                       const PlanSettings& settings) {
  PlanResult result;
  if (!start.allFinite() || !goal.allFinite() || !scene.isWithinLimits(start) || !scene.isWithinLimits(goal)) {
    result.outcome = PlanResult::Outcome::OutOfLimits;
    return result;
  }
  for (const bool isGoal : {false, true}) {
    result.blocked = blockerAt(scene, isGoal ? goal : start, settings.check, &result.queries);
    ++result.steps;
    if (result.blocked.link == kNone) continue;
    result.outcome = isGoal ? PlanResult::Outcome::GoalBlocked : PlanResult::Outcome::StartBlocked;
    return result;
  }
  return result;
}

JointRange planningRange(const RobotScene& scene, Eigen::Index joint, const ArmValues& start, const ArmValues& goal) {
  const ArmJoint& of = scene.joint(joint);
  const double far = of.isPrismatic ? 1000.0 : M_PI;
  JointRange range{std::isfinite(of.lower) ? of.lower : -far, std::isfinite(of.upper) ? of.upper : far};
  range.low = std::min({range.low, start[joint], goal[joint]});
  range.high = std::max({range.high, start[joint], goal[joint]});
  return range;
}

}  // namespace handwheel
