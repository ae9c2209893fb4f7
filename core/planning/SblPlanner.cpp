// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/SblPlanner.h"

#include "base/RandomSequence.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <queue>

namespace handwheel {

namespace {

constexpr std::uint32_t kNoParent = kNone;
constexpr int kCells = 10;  // of the grid, each way

// A free point, and the motion that joins it to the one before it in its tree.
struct Milestone {
  ArmValues values;
  std::uint32_t parent = kNoParent;
  std::shared_ptr<MotionCheck> motion;  // to the parent
  bool isOfGoal = false;                // which tree it is in
};

class Sbl {
 public:
  Sbl(const RobotScene& scene, const PlanSettings& settings, PlanResult& result)
      : m_scene(scene), m_settings(settings), m_result(result), m_random(settings.seed) {}

  void begin(const ArmValues& start, const ArmValues& goal) {
    for (Eigen::Index i = 0; i < m_scene.size(); ++i) {
      const JointRange range = planningRange(m_scene, i, start, goal);
      m_low[i] = range.low;
      m_high[i] = range.high;
    }
    add({start, kNoParent, nullptr, false});
    add({goal, kNoParent, nullptr, true});
    connect(1);
  }

  bool isSolved() const { return !m_result.path.empty(); }
  std::size_t count() const { return m_milestones.size(); }

  // A new milestone, and, where the other tree is near, a look at the path that this makes.
  void expand() {
    const bool isOfGoal = m_random.share() < 0.5;
    const std::uint32_t from = pick(isOfGoal);
    ArmValues values;
    for (int i = 1; i <= kMostTries; ++i) {
      values = near(m_milestones[from].values, m_settings.neighbourhood / i);
      if (!isFree(values)) continue;
      auto motion = std::make_shared<MotionCheck>(m_scene, values, m_milestones[from].values, m_settings.check);
      add({values, from, std::move(motion), isOfGoal});
      connect(static_cast<std::uint32_t>(m_milestones.size() - 1));
      return;
    }
  }

 private:
  static constexpr int kMostTries = 20;  // around one milestone

  void add(Milestone milestone) {
    m_cells[milestone.isOfGoal][cellOf(milestone.values)].push_back(static_cast<std::uint32_t>(m_milestones.size()));
    m_milestones.push_back(std::move(milestone));
  }

  double shareOf(Eigen::Index i, double value) const {
    return m_high[i] > m_low[i] ? (value - m_low[i]) / (m_high[i] - m_low[i]) : 0.5;
  }

  // Of a grid over the first two joints: these move the arm most.
  int cellOf(const ArmValues& values) const {
    int cell = 0;
    for (Eigen::Index i = 0; i < std::min<Eigen::Index>(2, values.size()); ++i)
      cell = cell * kCells + std::clamp(static_cast<int>(shareOf(i, values[i]) * kCells), 0, kCells - 1);
    return cell;
  }

  // First a cell, then a milestone in it: so that crowded places grow no faster than others.
  std::uint32_t pick(bool isOfGoal) {
    const auto& cells = m_cells[isOfGoal];
    auto cell = cells.begin();
    std::advance(cell, static_cast<std::ptrdiff_t>(m_random.below(cells.size())));
    return cell->second[m_random.below(cell->second.size())];
  }

  ArmValues near(const ArmValues& centre, double share) {
    ArmValues values = centre;
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const double far = share * (m_high[i] - m_low[i]);
      values[i] = m_random.between(std::max(m_low[i], centre[i] - far), std::min(m_high[i], centre[i] + far));
    }
    return values;
  }

  bool isFree(const ArmValues& values) {
    ++m_result.steps;
    return blockerAt(m_scene, values, m_settings.check, &m_result.queries).link == kNone;
  }

  // The largest share of a joint's range between them.
  double apart(const ArmValues& a, const ArmValues& b) const {
    double largest = 0.0;
    for (Eigen::Index i = 0; i < a.size(); ++i) {
      if (m_high[i] > m_low[i]) largest = std::max(largest, std::abs(a[i] - b[i]) / (m_high[i] - m_low[i]));
    }
    return largest;
  }

  // Joins the milestone to the nearest of the other tree, if that is near.
  void connect(std::uint32_t milestone) {
    std::uint32_t nearest = kNone;
    double least = m_settings.neighbourhood;
    for (std::uint32_t i = 0; i < m_milestones.size(); ++i) {
      if (m_milestones[i].isOfGoal == m_milestones[milestone].isOfGoal) continue;
      const double distance = apart(m_milestones[i].values, m_milestones[milestone].values);
      if (distance < least || (nearest == kNone && m_milestones.size() == 2)) {
        least = distance;
        nearest = i;
      }
    }
    if (nearest != kNone) tryPath(milestone, nearest);
  }

  std::vector<std::uint32_t> wayToRoot(std::uint32_t from) const {
    std::vector<std::uint32_t> way{from};
    while (m_milestones[way.back()].parent != kNoParent) way.push_back(m_milestones[way.back()].parent);
    return way;
  }

  // Checks the path over a bridge between the trees, the longest open piece first.
  void tryPath(std::uint32_t a, std::uint32_t b) {
    const auto bridge =
        std::make_shared<MotionCheck>(m_scene, m_milestones[a].values, m_milestones[b].values, m_settings.check);
    const std::uint32_t ofStart = m_milestones[a].isOfGoal ? b : a, ofGoal = m_milestones[a].isOfGoal ? a : b;
    struct Piece {
      double length;
      std::uint32_t child;  // kNone: the bridge
      bool operator<(const Piece& other) const { return length < other.length; }
    };
    std::priority_queue<Piece> open;
    const auto motionOf = [&](std::uint32_t child) -> MotionCheck& {
      return child == kNone ? *bridge : *m_milestones[child].motion;
    };
    const auto push = [&](std::uint32_t child) {
      if (motionOf(child).state() == MotionCheck::State::Open) open.push({motionOf(child).openLength(), child});
    };
    push(kNone);
    for (const std::uint32_t end : {ofStart, ofGoal}) {
      for (const std::uint32_t i : wayToRoot(end)) {
        if (m_milestones[i].motion) push(i);
      }
    }
    while (!open.empty()) {
      const std::uint32_t child = open.top().child;
      open.pop();
      ++m_result.steps;
      if (motionOf(child).step(&m_result.queries) == MotionCheck::State::Blocked) {
        if (child != kNone)
          transfer(child, m_milestones[child].isOfGoal ? ofGoal : ofStart,
                   m_milestones[child].isOfGoal ? ofStart : ofGoal, bridge);
        return;
      }
      push(child);
    }
    if (bridge->state() != MotionCheck::State::Free) return;
    std::vector<std::uint32_t> way = wayToRoot(ofStart);
    std::reverse(way.begin(), way.end());
    const std::vector<std::uint32_t> rest = wayToRoot(ofGoal);
    way.insert(way.end(), rest.begin(), rest.end());
    for (const std::uint32_t i : way) m_result.path.push_back(m_milestones[i].values);
  }

  // The motion of a milestone to its parent is blocked: what is beyond it hangs on the other tree by the bridge from
  // `end` now. Between `end` and the milestone the order of parents turns round.
  void transfer(std::uint32_t blocked, std::uint32_t end, std::uint32_t other,
                const std::shared_ptr<MotionCheck>& bridge) {
    std::uint32_t parent = other;
    std::shared_ptr<MotionCheck> motion = bridge;
    for (std::uint32_t i = end;;) {
      const std::uint32_t before = m_milestones[i].parent;
      std::swap(m_milestones[i].motion, motion);
      m_milestones[i].parent = parent;
      if (i == blocked) break;
      parent = i;
      i = before;
    }
    regroup();
  }

  // Which tree each milestone is in, by its root. O(milestones).
  void regroup() {
    std::vector<signed char> known(m_milestones.size(), -1);
    known[0] = 0;
    known[1] = 1;
    std::vector<std::uint32_t> way;
    for (auto& cells : m_cells) cells.clear();
    for (std::uint32_t i = 0; i < m_milestones.size(); ++i) {
      way.clear();
      std::uint32_t at = i;
      for (; known[at] < 0; at = m_milestones[at].parent) way.push_back(at);
      for (const std::uint32_t each : way) known[each] = known[at];
      m_milestones[i].isOfGoal = known[i] == 1;
      m_cells[m_milestones[i].isOfGoal][cellOf(m_milestones[i].values)].push_back(i);
    }
  }

  const RobotScene& m_scene;
  const PlanSettings& m_settings;
  PlanResult& m_result;
  RandomSequence m_random;
  ArmValues m_low = ArmValues::Zero(m_scene.size()), m_high = ArmValues::Zero(m_scene.size());
  std::vector<Milestone> m_milestones;                               // start and goal are the first two
  std::array<std::map<int, std::vector<std::uint32_t>>, 2> m_cells;  // of the start's tree and the goal's
};

}  // namespace

PlanResult planBySbl(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                     const PlanSettings& settings, Progress progress) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  PlanResult result = checkedEnds(scene, start, goal, settings);
  if (result.outcome != PlanResult::Outcome::TimeOut) return result;
  Sbl sbl(scene, settings, result);
  sbl.begin(start, goal);
  while (!sbl.isSolved() && sbl.count() < settings.mostMilestones) {
    if (progress.cancelled()) {
      result.outcome = PlanResult::Outcome::Cancelled;
      return result;
    }
    if (std::chrono::duration<double>(Clock::now() - begin).count() > settings.seconds) break;
    sbl.expand();
  }
  result.milestones = sbl.count();
  if (sbl.isSolved()) result.outcome = PlanResult::Outcome::Solved;
  return result;
}

}  // namespace handwheel
