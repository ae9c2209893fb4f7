// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/MotionCheck.h"

namespace handwheel {

class Roadmap;

// A path as its waypoints, with straight motions in joint space between them.
using JointPath = std::vector<ArmValues>;

// Settings of a planner.
struct PlanSettings {
  MotionCheckSettings check;
  double seconds = 2.0;  // time limit
  std::uint64_t seed = 1;
  // Distance from a milestone (a free configuration that was found) within which the next one is sought, as a fraction
  // of each joint's range.
  double neighbourhood = 0.2;
  std::size_t mostMilestones = 100'000;
  // Roadmap of the scene that the planner "prm" uses and extends; null: a temporary roadmap.
  Roadmap* roadmap = nullptr;
};

// The result of a planner.
struct PlanResult {
  enum class Outcome { Solved, StartBlocked, GoalBlocked, OutOfLimits, TimeOut, Cancelled };
  Outcome outcome = Outcome::TimeOut;
  JointPath path;                 // free at and between its waypoints; includes start and goal
  RobotScene::Nearest blocked{};  // the collision at the start or the goal, if it is blocked
  std::size_t milestones = 0;
  std::uint64_t steps = 0;  // number of points that were checked
  QueryCounts queries;
};

// Checks that start and goal are within the limits and free. If they are, the outcome is TimeOut, because there is no
// path yet; otherwise it is the problem.
PlanResult checkedEnds(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                       const PlanSettings& settings);

// The range of a joint for planning; rad, mm.
struct JointRange {
  double low, high;
};

// Returns the range of a joint for planning. It is given by the limits of the joint, or else by half a turn or a metre
// in each direction, and extended to contain start and goal.
JointRange planningRange(const RobotScene& scene, Eigen::Index joint, const ArmValues& start, const ArmValues& goal);

}  // namespace handwheel
