// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planning/MotionCheck.h"

namespace handwheel {

class Roadmap;

// A path of straight motions between these values, in joint space.
using JointPath = std::vector<ArmValues>;

// How a path is planned.
struct PlanSettings {
  MotionCheckSettings check;
  double seconds = 2.0;  // after which it is given up
  std::uint64_t seed = 1;
  double neighbourhood = 0.2;  // of the range of each joint: how far from a milestone the next one is looked for
  std::size_t mostMilestones = 100'000;
  Roadmap* roadmap = nullptr;  // of this scene, that "prm" uses and leaves for the next plan; null: for this one only
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

// Whether start and goal are within the limits and free: TimeOut where they are, else what is wrong.
PlanResult checkedEnds(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                       const PlanSettings& settings);

// In which range a joint is planned; rad, mm.
struct JointRange {
  double low, high;
};

// Its limits; without them half a turn or a metre each way, and more where start and goal need it.
JointRange planningRange(const RobotScene& scene, Eigen::Index joint, const ArmValues& start, const ArmValues& goal);

}  // namespace handwheel
