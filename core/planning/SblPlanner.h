// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/MotionCheck.h"

namespace handwheel {

// A path of straight motions between these values, in joint space.
using JointPath = std::vector<ArmValues>;

// How a path is planned.
struct PlanSettings {
  MotionCheckSettings check;
  double seconds = 2.0;  // after which it is given up
  std::uint64_t seed = 1;
  double neighbourhood = 0.15;  // of the range of each joint: how far from a milestone the next one is looked for
  std::size_t mostMilestones = 100'000;
};

// What became of it.
struct PlanResult {
  enum class Outcome { Solved, StartBlocked, GoalBlocked, OutOfLimits, TimeOut, Cancelled };
  Outcome outcome = Outcome::TimeOut;
  JointPath path;                 // free between its points, too; with start and goal
  RobotScene::Nearest blocked{};  // of start or goal
  std::size_t milestones = 0;
  std::uint64_t steps = 0;  // points that were looked at
  QueryCounts queries;
};

// Plans with single-query, bi-directional, lazy trees (SBL: Sánchez and Latombe 2001, A single-query bi-directional
// probabilistic roadmap planner with lazy collision checking). Milestones are free points, and the motions between them
// are checked only when they are on a path from start to goal: the piece that is longest and not known to be free comes
// first. Where a motion is blocked, the milestones beyond it go to the other tree. Here the checks prove what they find
// free, so that the path is free between its points.
PlanResult planBySbl(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                     const PlanSettings& settings, Progress progress = {});

}  // namespace handwheel
