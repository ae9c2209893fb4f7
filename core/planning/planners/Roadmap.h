// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

#include <mutex>
#include <unordered_map>

namespace handwheel {

// A probabilistic roadmap of a robot among obstacles, which is kept between plans. It consists of free configurations,
// the milestones, and the motions between neighbouring ones (PRM: Kavraki, Švestka, Latombe and Overmars 1996,
// Probabilistic roadmaps for path planning in high-dimensional configuration spaces). Motions are proven free
// (MotionCheck) only if they are on a path from start to goal (lazy PRM: Bohlin and Kavraki 2000), and the results are
// kept. If there is no path, the roadmap grows up to a number of milestones; when it is full, it is cleared.
//
// Its functions may be called on any thread; only one plan runs at a time, and other calls wait. All plans must be for
// the same scene, whose collisions must not change.
class Roadmap {
 public:
  static constexpr std::size_t kMostMilestones = 10'000;                  // about 10 MB with the motions
  explicit Roadmap(std::size_t most = kMostMilestones) : m_most(most) {}  // most: at least two

  // Plans a path. The roadmap is cleared first if the settings of the check differ from those of the last plan.
  PlanResult plan(const RobotScene& scene, const ArmValues& start, const ArmValues& goal, const PlanSettings& settings,
                  Progress progress = {});

  std::size_t milestones() const;
  std::size_t provenMotions() const;

 private:
  struct Motion {
    std::uint32_t a, b;  // indices of the milestones
    double length;       // rad; for slides a metre counts as a radian
    bool isFree = false;
  };
  struct Milestone {
    ArmValues values;
    std::vector<std::uint32_t> motions = {};  // motions that are not known to be blocked
  };
  struct Query;

  std::uint32_t placed(const RobotScene& scene, const ArmValues& values);
  std::vector<std::uint32_t> nearest(const RobotScene& scene, const ArmValues& values) const;
  std::vector<std::uint32_t> joinedTo(std::uint32_t milestone) const;
  bool grow(Query& query);
  std::vector<std::uint32_t> shortestPath(const Query& query) const;
  bool prove(Query& query, const std::vector<std::uint32_t>& path);
  void block(std::uint32_t motion);
  void clear();

  const std::size_t m_most;
  mutable std::mutex m_mutex;  // polled, because ThreadSanitizer does not support timed mutexes
  MotionCheckSettings m_check;
  std::uint64_t m_random = 0;  // state of the random numbers
  std::vector<Milestone> m_milestones;
  std::vector<Motion> m_motions;
};

}  // namespace handwheel
