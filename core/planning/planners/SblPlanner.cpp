// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/planners/SblPlanner.h"

#include "base/RandomSequence.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <queue>

namespace handwheel {

namespace {

constexpr std::uint32_t kNoParent = kNone;
constexpr int kCells = 32;  // cells of the grid in each direction

// A free configuration, and the motion that connects it to its parent in the tree.
struct Milestone {
  ArmValues values;
  std::uint32_t parent = kNoParent;
  std::vector<std::uint32_t> children = {};
  std::shared_ptr<MotionCheck> motion = nullptr;  // to the parent; null until it is needed
  bool isOfGoal = false;                          // true: it belongs to the tree of the goal
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
    add({.values = start, .isOfGoal = false});
    add({.values = goal, .isOfGoal = true});
    tryPath(1, 0);
  }

  bool isSolved() const { return !m_result.path.empty(); }
  std::size_t count() const { return m_milestones.size(); }

  // Adds a milestone, and, if the other tree is near, checks the resulting path.
  void expand() {
    const bool isOfGoal = m_random.share() < 0.5;
    const std::uint32_t from = pick(isOfGoal);
    ArmValues values;
    for (int i = 1; i <= kMostTries; ++i) {
      values = near(m_milestones[from].values, m_settings.neighbourhood / i);
      if (!isFree(values)) continue;
      add({.values = values, .parent = from, .isOfGoal = isOfGoal});
      connect(static_cast<std::uint32_t>(m_milestones.size() - 1));
      return;
    }
  }

 private:
  static constexpr int kMostTries = 20;  // around one milestone

  void add(Milestone milestone) {
    for (Eigen::Index i = 0; i < m_stride; ++i)
      m_shares.push_back(i < m_scene.size() ? shareOf(i, milestone.values[i]) : 0.0);
    const auto number = static_cast<std::uint32_t>(m_milestones.size());
    if (milestone.parent != kNoParent) m_milestones[milestone.parent].children.push_back(number);
    m_milestones.push_back(std::move(milestone));
    putInCell(number);
  }

  double shareOf(Eigen::Index i, double value) const {
    return m_high[i] > m_low[i] ? (value - m_low[i]) / (m_high[i] - m_low[i]) : 0.5;
  }
  // The positions of the joints of a milestone in their ranges, 0…1.
  const double* sharesOf(std::uint32_t milestone) const { return &m_shares[milestone * m_stride]; }

  static int cellAt(double share) { return std::clamp(static_cast<int>(share * kCells), 0, kCells - 1); }

  // The cells are a grid over the first two joints, which move the arm most.
  std::size_t cellOf(std::uint32_t milestone) const {
    const double* shares = sharesOf(milestone);
    return static_cast<std::size_t>(cellAt(shares[0]) * kCells + cellAt(shares[1]));
  }

  void putInCell(std::uint32_t milestone) {
    Cells& cells = m_cells[m_milestones[milestone].isOfGoal];
    const std::size_t cell = cellOf(milestone);
    if (cells.milestones[cell].empty()) cells.used.push_back(cell);
    cells.milestones[cell].push_back(milestone);
  }

  void takeFromCell(std::uint32_t milestone) {
    Cells& cells = m_cells[m_milestones[milestone].isOfGoal];
    const std::size_t cell = cellOf(milestone);
    std::erase(cells.milestones[cell], milestone);
    if (cells.milestones[cell].empty()) std::erase(cells.used, cell);
  }

  // Picks a cell, then a milestone in it, so that crowded regions grow no faster than others.
  std::uint32_t pick(bool isOfGoal) {
    const Cells& cells = m_cells[isOfGoal];
    const auto& in = cells.milestones[cells.used[m_random.below(cells.used.size())]];
    return in[m_random.below(in.size())];
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
    return isFreeAt(m_scene, values, m_settings.check, &m_result.queries);
  }

  // Connects the milestone to the nearest one of the other tree, if that is near: no joint differs by more than the
  // neighbourhood.
  void connect(std::uint32_t milestone) {
    const double* at = sharesOf(milestone);
    const double far = m_settings.neighbourhood;
    const Cells& cells = m_cells[!m_milestones[milestone].isOfGoal];
    std::uint32_t nearest = kNone;
    double least = far;
    for (int row = cellAt(at[0] - far); row <= cellAt(at[0] + far); ++row) {
      for (int column = cellAt(at[1] - far); column <= cellAt(at[1] + far); ++column) {
        for (const std::uint32_t i : cells.milestones[static_cast<std::size_t>(row * kCells + column)]) {
          const double* other = sharesOf(i);
          double apart = 0.0;
          for (Eigen::Index k = 0; k < m_stride && apart < least; ++k)
            apart = std::max(apart, std::abs(other[k] - at[k]));
          if (apart >= least) continue;
          least = apart;
          nearest = i;
        }
      }
    }
    if (nearest != kNone) tryPath(milestone, nearest);
  }

  std::vector<std::uint32_t> pathToRoot(std::uint32_t from) const {
    std::vector<std::uint32_t> path{from};
    while (m_milestones[path.back()].parent != kNoParent) path.push_back(m_milestones[path.back()].parent);
    return path;
  }

  std::shared_ptr<MotionCheck> motionBetween(std::uint32_t a, std::uint32_t b) const {
    return std::make_shared<MotionCheck>(m_scene, m_milestones[a].values, m_milestones[b].values, m_settings.check);
  }

  // Checks the path over a bridge between the trees, the longest open piece first.
  void tryPath(std::uint32_t a, std::uint32_t b) {
    const auto bridge = motionBetween(a, b);
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
      for (const std::uint32_t i : pathToRoot(end)) {
        if (m_milestones[i].parent == kNoParent) continue;
        if (!m_milestones[i].motion) m_milestones[i].motion = motionBetween(i, m_milestones[i].parent);
        push(i);
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
    std::vector<std::uint32_t> path = pathToRoot(ofStart);
    std::reverse(path.begin(), path.end());
    const std::vector<std::uint32_t> rest = pathToRoot(ofGoal);
    path.insert(path.end(), rest.begin(), rest.end());
    for (const std::uint32_t i : path) m_result.path.push_back(m_milestones[i].values);
  }

  // Handles a blocked motion of a milestone to its parent: the part beyond it now belongs to the other tree through the
  // bridge at `end`. Between `end` and the milestone the order of parents is reversed.
  void transfer(std::uint32_t blocked, std::uint32_t end, std::uint32_t other,
                const std::shared_ptr<MotionCheck>& bridge) {
    std::uint32_t parent = other;
    std::shared_ptr<MotionCheck> motion = bridge;
    for (std::uint32_t i = end;;) {
      const std::uint32_t before = m_milestones[i].parent;
      std::erase(m_milestones[before].children, i);
      m_milestones[parent].children.push_back(i);
      std::swap(m_milestones[i].motion, motion);
      m_milestones[i].parent = parent;
      if (i == blocked) break;
      parent = i;
      i = before;
    }
    std::vector<std::uint32_t> moved{end};  // and all milestones beyond it
    for (std::size_t k = 0; k < moved.size(); ++k) {
      Milestone& milestone = m_milestones[moved[k]];
      takeFromCell(moved[k]);
      milestone.isOfGoal = !milestone.isOfGoal;
      putInCell(moved[k]);
      moved.insert(moved.end(), milestone.children.begin(), milestone.children.end());
    }
  }

  const RobotScene& m_scene;
  const PlanSettings& m_settings;
  PlanResult& m_result;
  RandomSequence m_random;
  ArmValues m_low = ArmValues::Zero(m_scene.size()), m_high = ArmValues::Zero(m_scene.size());
  std::vector<Milestone> m_milestones;  // start and goal are the first two
  const Eigen::Index m_stride = std::max<Eigen::Index>(2, m_scene.size());
  std::vector<double> m_shares;  // shares of all milestones, one after the other, padded with 0 if there is one joint
  struct Cells {
    std::array<std::vector<std::uint32_t>, kCells * kCells> milestones;
    std::vector<std::size_t> used;  // the occupied ones
  };
  std::array<Cells, 2> m_cells;  // trees of the start and of the goal
};

}  // namespace

PlanResult planBySbl(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                     const PlanSettings& settings, Progress progress) {
  const auto begin = std::chrono::steady_clock::now();
  PlanResult result = checkedEnds(scene, start, goal, settings);
  if (result.outcome != PlanResult::Outcome::TimeOut) return result;
  Sbl sbl(scene, settings, result);
  sbl.begin(start, goal);
  while (!sbl.isSolved() && sbl.count() < settings.mostMilestones) {
    if (progress.cancelled()) {
      result.outcome = PlanResult::Outcome::Cancelled;
      return result;
    }
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > settings.seconds) break;
    sbl.expand();
  }
  result.milestones = sbl.count();
  if (sbl.isSolved()) result.outcome = PlanResult::Outcome::Solved;
  return result;
}

}  // namespace handwheel
