// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/ToolTrack.h"

#include "robot/arm/ClosedFormIk.h"
#include "robot/arm/NumericalIk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace handwheel {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

// Returns the largest move of a joint. Slides count a thousandth: 1 m as 1 rad.
double distanceOf(const SerialArm& arm, const ArmValues& from, const ArmValues& to) {
  double most = 0.0;
  for (Eigen::Index i = 0; i < arm.size(); ++i) {
    const double difference = std::abs(to[i] - from[i]);
    most = std::max(most, arm.joints()[static_cast<std::size_t>(i)].isPrismatic ? 1e-3 * difference : difference);
  }
  return most;
}

// The steps of the ladder graph and the shortest path through it.
class Ladder {
 public:
  Ladder(const RobotScene& scene, const SerialArm& arm, const Pose& tool, std::span<const Pose> poses,
         const ArmValues& near, const TrackSettings& settings)
      : m_scene(scene),
        m_arm(arm),
        m_tool(tool),
        m_poses(poses),
        m_near(near),
        m_settings(settings),
        m_closed(ClosedFormIk::of(arm)) {}

  FollowedTrack climb(Progress progress) {
    FollowedTrack found;
    for (std::size_t i = 0; i < m_poses.size(); ++i) {
      addRung(i);
      progress.set(0.3 * static_cast<double>(i) / static_cast<double>(m_poses.size()));
      if (progress.cancelled()) return {.outcome = FollowedTrack::Outcome::Cancelled};
      if (m_rungs.back().empty()) return {.outcome = FollowedTrack::Outcome::OutOfReach, .failedAt = i};
    }
    for (;;) {
      const std::size_t reached = findPaths();
      if (reached < m_poses.size()) return failedAt(reached);
      const std::vector<std::size_t> path = shortest();
      const std::size_t checked = firstBad(path, progress);
      if (progress.cancelled()) return {.outcome = FollowedTrack::Outcome::Cancelled};
      if (checked < path.size()) continue;
      found.outcome = FollowedTrack::Outcome::Solved;
      for (std::size_t i = 0; i < path.size(); ++i) found.values.push_back(m_rungs[i][path[i]].values);
      return found;
    }
  }

 private:
  struct Step {
    ArmValues values;
    int spin = 0;
    bool isFree = false;     // known to be
    bool isBlocked = false;  // known to be
    RobotScene::Nearest blocked{};
    double cost = kFar;
    std::size_t before = 0;             // index in the rung below
    std::set<std::size_t> badBefore{};  // steps below without a valid line to this one
    RobotScene::Nearest lineBlocked{};
  };

  // Adds a step. The joints are shifted by whole turns as near to the reference as their limits allow.
  void add(std::vector<Step>& rung, const ArmValues& values, int spin, const ArmValues& reference) const {
    const auto within = withinLimits(m_arm, values, reference);
    if (!within) return;
    const auto isSame = [&](const Step& step) {
      return step.spin == spin && distanceOf(m_arm, step.values, *within) < 1e-4;
    };
    if (std::none_of(rung.begin(), rung.end(), isSame)) rung.push_back({.values = *within, .spin = spin});
  }

  // Whole turns are counted from the first rung: a joint that keeps turning stays on its path.
  void addRung(std::size_t i) {
    std::vector<Step> rung;
    const std::vector<Step> none;
    const std::vector<Step>& below = i > 0 ? m_rungs.back() : none;
    for (int spin = 0; spin < m_settings.spins; ++spin) {
      const double turn = 2.0 * std::numbers::pi * spin / m_settings.spins;
      const Pose tip = m_poses[i] * Eigen::AngleAxisd(turn, Vec3::UnitZ()) * m_tool.inverse(Eigen::Isometry);
      if (m_closed) {
        IkSolutions solutions;
        m_closed->solve(tip, m_near, solutions);
        for (const IkSolutions::Solution& solution : solutions) {
          add(rung, solution.values, spin, m_near);
          for (const Step& step : below) {
            if (isNextSpin(step.spin, spin)) add(rung, solution.values, spin, step.values);
          }
        }
      } else {
        addNumerically(rung, tip, spin, below);
      }
    }
    m_rungs.push_back(std::move(rung));
  }

  // Adds solutions found from the steps below, and for the first rung from random starts.
  void addNumerically(std::vector<Step>& rung, const Pose& tip, int spin, const std::vector<Step>& below) const {
    constexpr std::uint64_t kRandomStarts = 12;
    NumericalIkSettings ik{.tolerance = 1e-9, .seconds = 0.05};
    const auto addFrom = [&](const ArmValues& start) {
      const NumericalIkResult solved = solvedNumerically(m_arm, tip, start, ik);
      if (solved.isSolved) add(rung, solved.values, spin, start);
    };
    ik.mostStarts = 1;
    for (const Step& step : below) {
      if (isNextSpin(step.spin, spin)) addFrom(step.values);
    }
    if (!rung.empty()) return;
    addFrom(m_near);
    ik.mostStarts = 1'000'000;
    for (std::uint64_t seed = 1; seed <= kRandomStarts; ++seed) {
      ik.seed = seed;
      ArmValues start = m_arm.middle();
      if (seed > 1) start = start.array() + 0.37 * static_cast<double>(seed % 5) - 0.7;
      addFrom(start);
    }
  }

  bool isNextSpin(int a, int b) const {
    const int apart = std::abs(a - b);
    return std::min(apart, m_settings.spins - apart) <= 1;
  }

  // Finds the cheapest path to every step. Returns the number of rungs that can be reached.
  std::size_t findPaths() {
    for (std::size_t i = 0; i < m_rungs.size(); ++i) {
      bool isReached = false;
      for (Step& step : m_rungs[i]) {
        step.cost = step.isBlocked ? kFar : i == 0 ? distanceOf(m_arm, m_near, step.values) : kFar;
        if (i > 0 && !step.isBlocked) findPathTo(step, m_rungs[i - 1]);
        isReached |= step.cost < kFar;
      }
      if (!isReached) return i;
    }
    return m_rungs.size();
  }

  // A line of the tool on which a joint makes a quarter turn or more is a leap from one configuration to another.
  void findPathTo(Step& step, const std::vector<Step>& below) const {
    constexpr double kLeap = 0.5 * std::numbers::pi;
    for (std::size_t j = 0; j < below.size(); ++j) {
      if (!(below[j].cost < step.cost) || !isNextSpin(below[j].spin, step.spin) || step.badBefore.contains(j)) continue;
      const double distance = distanceOf(m_arm, below[j].values, step.values);
      if (distance >= kLeap || below[j].cost + distance >= step.cost) continue;
      step.cost = below[j].cost + distance;
      step.before = j;
    }
  }

  std::vector<std::size_t> shortest() const {
    std::vector<std::size_t> path(m_rungs.size());
    const auto isCheaper = [](const Step& a, const Step& b) { return a.cost < b.cost; };
    const auto& last = m_rungs.back();
    path.back() = static_cast<std::size_t>(std::min_element(last.begin(), last.end(), isCheaper) - last.begin());
    for (std::size_t i = path.size() - 1; i > 0; --i) path[i - 1] = m_rungs[i][path[i]].before;
    return path;
  }

  // Marks the unusable parts of a path: all steps first, then lines up to the first bad one. Returns the number of good
  // steps.
  std::size_t firstBad(const std::vector<std::size_t>& path, Progress progress) {
    std::size_t good = path.size();
    for (std::size_t i = 0; i < path.size() && !progress.cancelled(); ++i) {
      Step& step = m_rungs[i][path[i]];
      if (step.isFree) continue;
      step.blocked = blockerAt(m_scene, step.values, m_settings.check);
      step.isFree = step.blocked.link == kNone;
      step.isBlocked = !step.isFree;
      if (step.isBlocked) good = std::min(good, i);
    }
    if (good < path.size()) return good;
    for (std::size_t i = 1; i < path.size() && !progress.cancelled(); ++i) {
      Step& step = m_rungs[i][path[i]];
      const std::pair<std::size_t, std::pair<std::size_t, std::size_t>> line{i, {path[i - 1], path[i]}};
      if (m_goodLines.contains(line)) continue;
      const double share = 0.3 + 0.7 * static_cast<double>(i) / static_cast<double>(path.size());
      const CheckedLine checked = checkLine(m_scene, m_arm, m_tool, m_rungs[i - 1][path[i - 1]].values, step.values,
                                            m_settings.line, m_settings.check, progress.part(share, share));
      if (checked.isFree()) {
        m_goodLines.insert(line);
        continue;
      }
      step.badBefore.insert(path[i - 1]);
      if (checked.blocked.link != kNone) step.lineBlocked = checked.blocked;
      return i;
    }
    return path.size();
  }

  // Reports a rung at which every step is blocked, or cannot be reached from below; a collision says more than a leap.
  FollowedTrack failedAt(std::size_t rung) const {
    FollowedTrack failed{.outcome = FollowedTrack::Outcome::NoPath, .failedAt = rung};
    for (const Step& step : m_rungs[rung]) {
      const RobotScene::Nearest& found = step.blocked.link != kNone ? step.blocked : step.lineBlocked;
      if (found.link == kNone) continue;
      failed.outcome = FollowedTrack::Outcome::Blocked;
      failed.blocked = found;
    }
    return failed;
  }

  const RobotScene& m_scene;
  const SerialArm& m_arm;
  Pose m_tool;
  std::span<const Pose> m_poses;
  ArmValues m_near;
  TrackSettings m_settings;
  std::optional<ClosedFormIk> m_closed;
  std::vector<std::vector<Step>> m_rungs;
  std::set<std::pair<std::size_t, std::pair<std::size_t, std::size_t>>> m_goodLines;  // rung; step below, step
};

}  // namespace

std::vector<Pose> toolPoses(const SurfaceTrack& track, const ToolAttitude& attitude) {
  std::vector<Pose> poses;
  for (const TrackPoint& point : track.points) {
    Pose pose = Pose::Identity();
    pose.linear().col(0) = point.direction;
    pose.linear().col(2) = -point.normal;
    pose.linear().col(1) = pose.linear().col(2).cross(pose.linear().col(0));
    pose.translation() = point.position;
    pose.rotate(Eigen::AngleAxisd(attitude.tilt, Vec3::UnitX()));
    pose.rotate(Eigen::AngleAxisd(attitude.lead, Vec3::UnitY()));
    pose.rotate(Eigen::AngleAxisd(attitude.spin, Vec3::UnitZ()));
    pose.translate(Vec3(0, 0, -attitude.standoff));
    poses.push_back(pose);
  }
  return poses;
}

FollowedTrack followTrack(const RobotScene& scene, const SerialArm& arm, const Pose& tool, std::span<const Pose> poses,
                          const ArmValues& near, const TrackSettings& settings, Progress progress) {
  if (poses.empty()) return {};
  return Ladder(scene, arm, tool, poses, near, settings).climb(progress);
}

CheckedLine checkLine(const RobotScene& scene, const SerialArm& arm, const Pose& tool, const ArmValues& from,
                      const ArmValues& to, const LineSettings& line, MotionCheckSettings check, Progress progress) {
  const FollowedLine followed = followLine(arm, tool, from, to, line, progress);
  CheckedLine checked{.reached = followed.reached};
  for (std::size_t i = 1; i < followed.path.size() && checked.reached >= 1.0; ++i) {
    const double off = scene.travelBound(followed.path[i - 1], followed.path[i], followed.offs[i - 1]);
    const MotionCheckSettings wider = widened(check, off);  // deviation of the arm from the line
    MotionCheck motion(scene, followed.path[i - 1], followed.path[i], wider);
    motion.run(progress);
    checked.steps += motion.steps();
    if (motion.state() == MotionCheck::State::Free) continue;
    checked.blocked = motion.blockedBy();
    break;
  }
  return checked;
}

}  // namespace handwheel
