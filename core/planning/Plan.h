// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/MotionCheck.h"

namespace handwheel {

class Roadmap;

// A path of straight motions between these values, in joint space.
using JointPath = std::vector<ArmValues>;

// Settings of a planner.
struct PlanSettings {
  MotionCheckSettings check;
  double seconds = 2.0;  // time limit
  std::uint64_t seed = 1;
  // Distance from a milestone within which the next one is sought, as a share of each joint's range.
  double neighbourhood = 0.2;
  std::size_t mostMilestones = 100'000;
  // Roadmap of this scene that "prm" uses and keeps for the next plan; null: a temporary one.
  Roadmap* roadmap = nullptr;
};

// The result of a planner.
struct PlanResult {
  enum class Outcome { Solved, StartBlocked, GoalBlocked, OutOfLimits, TimeOut, Cancelled };
  Outcome outcome = Outcome::TimeOut;
  JointPath path;                 // free between its waypoints, too; includes start and goal
  RobotScene::Nearest blocked{};  // the collision at the start or goal
  std::size_t milestones = 0;
  std::uint64_t steps = 0;  // number of points that were checked
  QueryCounts queries;
};

// Checks that start and goal are within the limits and free. The outcome is TimeOut if they are, otherwise the problem.
PlanResult checkedEnds(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                       const PlanSettings& settings);

// The range in which a joint is planned; rad, mm.
struct JointRange {
  double low, high;
};

// Returns the limits of a joint; without limits half a turn or a metre in each direction, and more if start and goal
// need it.
JointRange planningRange(const RobotScene& scene, Eigen::Index joint, const ArmValues& start, const ArmValues& goal);

}  // namespace handwheel
