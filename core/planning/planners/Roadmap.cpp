// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/planners/Roadmap.h"

#include "base/RandomSequence.h"
#include "planning/PathShortcuts.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <queue>
#include <thread>

namespace handwheel {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kNeighbours = 10;  // number of neighbours that a new milestone is connected to
constexpr std::size_t kLeastGrowth = 20;
constexpr double kUnproven = 1.3;  // factor of its length: proven motions are preferred

}  // namespace

// One plan.
struct Roadmap::Query {
  const RobotScene& scene;
  const PlanSettings& settings;
  PlanResult& result;
  Progress progress;
  Clock::time_point begin = Clock::now();
  std::uint32_t start = kNone, goal = kNone;
  std::unordered_map<std::uint32_t, MotionCheck> open = {};  // checks of motions that have begun

  bool isOver() const {
    return progress.cancelled() || std::chrono::duration<double>(Clock::now() - begin).count() > settings.seconds;
  }
};

std::size_t Roadmap::milestones() const {
  const std::lock_guard lock(m_mutex);
  return m_milestones.size();
}

std::size_t Roadmap::provenMotions() const {
  const std::lock_guard lock(m_mutex);
  return static_cast<std::size_t>(std::ranges::count_if(m_motions, &Motion::isFree));
}

void Roadmap::clear() {
  m_milestones.clear();
  m_motions.clear();
}

// Returns the milestones next to these values, the nearest first.
std::vector<std::uint32_t> Roadmap::nearest(const RobotScene& scene, const ArmValues& values) const {
  std::vector<std::pair<double, std::uint32_t>> all;
  for (std::uint32_t i = 0; i < m_milestones.size(); ++i) {
    double square = 0.0;
    for (Eigen::Index k = 0; k < values.size(); ++k) {
      const double difference = (m_milestones[i].values[k] - values[k]) * (scene.joint(k).isPrismatic ? 1e-3 : 1.0);
      square += difference * difference;
    }
    all.emplace_back(square, i);
  }
  const auto count = static_cast<std::ptrdiff_t>(std::min(kNeighbours, all.size()));
  std::partial_sort(all.begin(), all.begin() + count, all.end());
  std::vector<std::uint32_t> near;
  for (std::ptrdiff_t i = 0; i < count; ++i) near.push_back(all[static_cast<std::size_t>(i)].second);
  return near;
}

// Returns the milestone at these values, which are free: an existing one, or a new one connected to its neighbours.
std::uint32_t Roadmap::placed(const RobotScene& scene, const ArmValues& values) {
  const std::vector<std::uint32_t> near = nearest(scene, values);
  if (!near.empty() && m_milestones[near.front()].values == values) return near.front();
  const auto number = static_cast<std::uint32_t>(m_milestones.size());
  m_milestones.push_back({values});
  for (const std::uint32_t other : near) {
    const auto motion = static_cast<std::uint32_t>(m_motions.size());
    m_motions.push_back({other, number, lengthOf(scene, m_milestones[other].values, values)});
    m_milestones[other].motions.push_back(motion);
    m_milestones[number].motions.push_back(motion);
  }
  return number;
}

// Returns the milestones that are connected to this one by motions that are not known to be blocked.
std::vector<std::uint32_t> Roadmap::joinedTo(std::uint32_t milestone) const {
  std::vector<bool> isKnown(m_milestones.size(), false);
  std::vector<std::uint32_t> all{milestone};
  isKnown[milestone] = true;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const std::uint32_t m : m_milestones[all[i]].motions) {
      const std::uint32_t next = m_motions[m].a == all[i] ? m_motions[m].b : m_motions[m].a;
      if (isKnown[next]) continue;
      isKnown[next] = true;
      all.push_back(next);
    }
  }
  return all;
}

// Adds milestones: most of them around those that are connected to start and goal, nearer and nearer until a
// configuration is free, the others anywhere. Returns false if it is full, or the plan is over.
bool Roadmap::grow(Query& query) {
  constexpr double kAnywhere = 0.25;
  constexpr int kMostTries = 20;  // around one milestone
  const std::size_t most = std::min(m_most, query.settings.mostMilestones);
  const std::size_t wanted = std::min(most, m_milestones.size() + kLeastGrowth);
  if (m_milestones.size() >= wanted) return false;
  std::vector<JointRange> ranges;
  for (Eigen::Index i = 0; i < query.scene.size(); ++i)
    ranges.push_back(planningRange(query.scene, i, m_milestones[query.start].values, m_milestones[query.goal].values));
  const std::array<std::vector<std::uint32_t>, 2> sides{joinedTo(query.start), joinedTo(query.goal)};
  const auto tryAt = [&](RandomSequence& random, const ArmValues* around, double share) {
    ArmValues values(query.scene.size());
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const auto [low, high] = ranges[static_cast<std::size_t>(i)];
      const double far = share * (high - low);
      values[i] = around ? random.between(std::max(low, (*around)[i] - far), std::min(high, (*around)[i] + far))
                         : random.between(low, high);
    }
    ++query.result.steps;
    if (!isFreeAt(query.scene, values, m_check, &query.result.queries)) return false;
    placed(query.scene, values);
    return true;
  };
  while (m_milestones.size() < wanted && !query.isOver()) {
    RandomSequence random(m_random++);
    if (random.share() < kAnywhere) {
      tryAt(random, nullptr, 1.0);
      continue;
    }
    const std::vector<std::uint32_t>& side = sides[random.below(2)];
    const ArmValues around = m_milestones[side[random.below(side.size())]].values;
    for (int i = 1; i <= kMostTries && !tryAt(random, &around, query.settings.neighbourhood / i); ++i) {
    }
  }
  return !query.isOver();
}

// Returns the path from start to goal over motions that are not known to be blocked; empty: there is none (A*: Hart,
// Nilsson and Raphael 1968).
std::vector<std::uint32_t> Roadmap::shortestPath(const Query& query) const {
  const std::size_t count = m_milestones.size();
  std::vector<double> least(count, std::numeric_limits<double>::infinity());
  std::vector<std::uint32_t> by(count, kNone);  // the motion that leads to each milestone
  const ArmValues& goal = m_milestones[query.goal].values;
  const auto rest = [&](std::uint32_t i) { return lengthOf(query.scene, m_milestones[i].values, goal); };
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<bool> isDone(count, false);
  least[query.start] = 0.0;
  open.push({rest(query.start), query.start});
  while (!open.empty() && !isDone[query.goal]) {
    const std::uint32_t at = open.top().second;
    open.pop();
    if (isDone[at]) continue;
    isDone[at] = true;
    for (const std::uint32_t m : m_milestones[at].motions) {
      const Motion& motion = m_motions[m];
      const std::uint32_t next = motion.a == at ? motion.b : motion.a;
      const double length = least[at] + motion.length * (motion.isFree ? 1.0 : kUnproven);
      if (length >= least[next]) continue;
      least[next] = length;
      by[next] = m;
      open.push({length + rest(next), next});
    }
  }
  std::vector<std::uint32_t> path;
  for (std::uint32_t at = query.goal; at != query.start && by[at] != kNone;) {
    path.push_back(by[at]);
    at = m_motions[by[at]].a == at ? m_motions[by[at]].b : m_motions[by[at]].a;
  }
  std::reverse(path.begin(), path.end());
  return path;
}

void Roadmap::block(std::uint32_t motion) {
  std::erase(m_milestones[m_motions[motion].a].motions, motion);
  std::erase(m_milestones[m_motions[motion].b].motions, motion);
}

// Checks the motions of a path, the longest open piece first, until all are proven free, or one is blocked.
bool Roadmap::prove(Query& query, const std::vector<std::uint32_t>& path) {
  std::priority_queue<std::pair<double, std::uint32_t>> pieces;
  for (const std::uint32_t m : path) {
    Motion& motion = m_motions[m];
    if (motion.isFree) continue;
    const MotionCheck fresh(query.scene, m_milestones[motion.a].values, m_milestones[motion.b].values, m_check);
    pieces.push({query.open.try_emplace(m, fresh).first->second.openLength(), m});
  }
  while (!pieces.empty()) {
    if (query.isOver()) return false;
    const std::uint32_t m = pieces.top().second;
    pieces.pop();
    MotionCheck& check = query.open.at(m);
    ++query.result.steps;
    switch (check.step(&query.result.queries)) {
      case MotionCheck::State::Open:
        pieces.push({check.openLength(), m});
        continue;
      case MotionCheck::State::Free:
        m_motions[m].isFree = true;
        query.open.erase(m);
        continue;
      case MotionCheck::State::Blocked:
        query.open.erase(m);
        block(m);
        return false;
    }
  }
  return true;
}

PlanResult Roadmap::plan(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                         const PlanSettings& settings, Progress progress) {
  PlanResult result = checkedEnds(scene, start, goal, settings);
  if (result.outcome != PlanResult::Outcome::TimeOut) return result;
  std::unique_lock lock(m_mutex, std::defer_lock);
  while (!lock.try_lock() && !progress.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  if (progress.cancelled()) {
    result.outcome = PlanResult::Outcome::Cancelled;
    return result;
  }
  const bool isOther = !(m_check == settings.check) || m_milestones.size() + 2 > m_most;
  if (isOther || m_milestones.empty()) {
    clear();
    m_check = settings.check;
    m_random = settings.seed << 32;
  }
  Query query{scene, settings, result, progress};
  query.start = placed(scene, start);
  query.goal = placed(scene, goal);
  while (!query.isOver()) {
    const std::vector<std::uint32_t> path = shortestPath(query);
    if (path.empty() && query.start != query.goal) {
      if (!grow(query)) break;
      continue;
    }
    if (!prove(query, path)) continue;
    result.path = {start};
    std::uint32_t at = query.start;
    for (const std::uint32_t m : path) {
      at = m_motions[m].a == at ? m_motions[m].b : m_motions[m].a;
      result.path.push_back(m_milestones[at].values);
    }
    if (path.empty()) result.path.push_back(goal);
    result.outcome = PlanResult::Outcome::Solved;
    break;
  }
  if (result.path.empty() && progress.cancelled()) result.outcome = PlanResult::Outcome::Cancelled;
  result.milestones = m_milestones.size();
  return result;
}

}  // namespace handwheel
