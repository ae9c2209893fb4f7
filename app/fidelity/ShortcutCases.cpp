// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/ArmAmongBoxes.h"
#include "fidelity/Cases.h"
#include "planning/PathShortcuts.h"
#include "planning/planners/SblPlanner.h"

#include <algorithm>

namespace handwheel {
namespace {

constexpr double kLongestSearch = 1e3;          // s: no time decides on the result, but
constexpr std::size_t kMostMilestones = 3'000;  // their number; what needs more is no task

struct Task {
  ArmValues start, goal;
  double shortest;  // rad, of all paths that were found
};

struct Tasks {
  ArmAmongBoxes cell;
  std::vector<Task> all = {};
};

JointPath planned(const RobotScene& scene, const Task& task, int shortcuts, std::uint64_t seed) {
  PlanSettings settings;
  settings.seconds = kLongestSearch;
  settings.seed = seed;
  settings.mostMilestones = kMostMilestones;
  PlanResult result = planBySbl(scene, task.start, task.goal, settings);
  return shortened(scene, std::move(result.path), settings.check, shortcuts, kLongestSearch, seed);
}

// Returns tasks whose straight path is blocked.
Tasks tasksAmong(double thickness, std::uint64_t seed) {
  constexpr std::size_t kTasks = 6;
  constexpr int kMany = 1000;  // attempts for the shortest path
  Tasks tasks{ArmAmongBoxes(thickness, seed)};
  const RobotScene& scene = tasks.cell.scene();
  Random random(seed + 2);
  while (tasks.all.size() < kTasks) {
    Task task{tasks.cell.anywhereFree(random), tasks.cell.anywhereFree(random), 1e9};
    if (MotionCheck(scene, task.start, task.goal, {}).run() == MotionCheck::State::Free) continue;
    bool isTask = true;
    for (std::uint64_t other = 1; other <= 4 && isTask; ++other) {
      const JointPath path = planned(scene, task, kMany, other);
      isTask = !path.empty();
      if (isTask) task.shortest = std::min(task.shortest, lengthOf(scene, path));
    }
    if (isTask) tasks.all.push_back(task);
  }
  return tasks;
}

FidelityCase caseAmong(const std::string& name, double thickness) {
  const SeededInput<Tasks> input([thickness](std::uint64_t seed) { return tasksAmong(thickness, seed); });
  return {name, "shortest of four paths with 1000 attempts each", [input](double value, std::uint64_t seed, Progress) {
            const Tasks& tasks = input(seed);
            double excess = 0.0, ms = 0.0;
            for (const Task& task : tasks.all) {
              JointPath path;
              ms += cpuMilliseconds([&] { path = planned(tasks.cell.scene(), task, static_cast<int>(value), seed); });
              if (path.empty()) return FidelitySample{std::numeric_limits<double>::infinity(), ms};
              excess += std::max(0.0, lengthOf(tasks.cell.scene(), path) / task.shortest - 1.0);
            }
            const auto count = static_cast<double>(tasks.all.size());
            return FidelitySample{100.0 * excess / count, ms / count};
          }};
}

}  // namespace

std::vector<FidelityCase> planShortcutsCases() {
  return {caseAmong("arm among plates of 4 mm", 4.0), caseAmong("arm among blocks of 120 mm", 120.0)};
}

}  // namespace handwheel
