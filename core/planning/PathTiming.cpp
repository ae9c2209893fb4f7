// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PathTiming.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace handwheel {

namespace {

constexpr double kSlowest = 1e-3;  // share of the largest velocities

JointRates ratesOf(const RobotScene& scene, const PathTimingSettings& settings) {
  ArmValues velocity(scene.size());
  for (Eigen::Index k = 0; k < scene.size(); ++k) {
    const ArmJoint& joint = scene.joint(k);
    velocity[k] = joint.velocity.value_or(0.0) > 0.0 ? *joint.velocity
                  : joint.isPrismatic                ? settings.sliding
                                                     : settings.turning;
  }
  const ArmValues acceleration = velocity / settings.timeToSpeed;
  return {velocity, acceleration, acceleration / settings.timeToRamp};
}

// Returns the duration of a motion in which the slowest joint has its largest velocity; 0: nothing moves.
double leastDuration(const ArmValues& displacement, const JointRates& most) {
  return displacement.size() == 0 ? 0.0 : (displacement.array().abs() / most.velocity.array()).maxCoeff();
}

// Returns true if the speed of the motion is that of the tool.
bool isOfTool(const MotionPace& pace) {
  return pace.length > 0.0 && pace.toolSpeed > 0.0;
}

// Returns the duration of a motion at its own speed, without acceleration.
double durationOf(const ArmValues& displacement, const JointRates& most, const MotionPace& pace, double speed) {
  const double joints = leastDuration(displacement, most);
  const double slower = std::clamp(speed, kSlowest, 1.0);
  if (isOfTool(pace)) return std::max(joints, pace.length / pace.toolSpeed) / slower;
  return joints / (slower * (pace.toolSpeed > 0.0 ? 1.0 : std::clamp(pace.speed, kSlowest, 1.0)));
}

// Returns the zones at the ends of motions as durations, alike before and behind each end. A zone reaches half of the
// way to the neighbouring ones at most.
std::vector<double> zonesOf(std::span<const double> durations, std::span<const MotionPace> paces) {
  std::vector<double> zones(durations.size(), 0.0);
  // Durations of the way from motion i on, in one direction, for a length of the tool's way.
  const auto reach = [&](std::size_t i, bool isBack, double length) {
    double passed = 0.0, whole = 0.0, left = length;
    for (std::size_t k = i; k < durations.size(); isBack ? --k : ++k) {  // below 0 it is larger than the size
      const bool isOn = left > 0.0;
      const double share = paces[k].length > 0.0 ? std::min(1.0, left / paces[k].length) : 1.0;
      if (isOn) passed += share * durations[k];
      left -= paces[k].length;
      whole += durations[k];
      const bool isEnd = isBack ? k == 0 || paces[k - 1].zone > 0.0 : paces[k].zone > 0.0;
      if (isEnd) break;
    }
    return std::min(passed, 0.5 * whole);
  };
  for (std::size_t i = 0; i + 1 < durations.size(); ++i) {
    if (paces[i].zone > 0.0) zones[i] = std::min(reach(i, true, paces[i].zone), reach(i + 1, false, paces[i].zone));
  }
  return zones;
}

}  // namespace

TimedPath::TimedPath(const RobotScene& scene, JointPath path, const PathTimingSettings& settings,
                     std::span<const MotionPace> paces)
    : m_path(std::move(path)) {
  const std::size_t count = m_path.empty() ? 0 : m_path.size() - 1;
  std::vector<MotionPace> all(paces.begin(),
                              paces.begin() + static_cast<std::ptrdiff_t>(std::min(count, paces.size())));
  all.resize(count);
  const JointRates most = ratesOf(scene, settings);
  for (std::size_t first = 0, end = 0; first < count; first = end) {
    end = first + 1;
    while (end < count && all[end - 1].isContinued) ++end;
    addRun(first, end, most, settings, all);
  }
  m_begins.push_back(m_runs.empty() ? 0.0 : m_runs.back().begin + m_runs.back().motions.duration());
}

void TimedPath::addRun(std::size_t first, std::size_t end, const JointRates& most, const PathTimingSettings& settings,
                       std::span<const MotionPace> paces) {
  const auto own = paces.subspan(first, end - first);
  const std::span<const ArmValues> points = std::span<const ArmValues>(m_path).subspan(first, own.size() + 1);
  std::vector<double> durations, extents;
  for (std::size_t i = 0; i < own.size(); ++i)
    durations.push_back(durationOf(points[i + 1] - points[i], most, own[i], settings.speed));
  const bool isBlended =
      std::any_of(own.begin(), own.end() - 1, [](const MotionPace& pace) { return pace.zone > 0.0; });
  const double begin = m_runs.empty() ? 0.0 : m_runs.back().begin + m_runs.back().motions.duration();
  if (isBlended) {
    extents = durations;
    m_runs.push_back({begin, TimedRun::blended(points, extents, zonesOf(durations, own), most)});
  } else {
    // A line has one speed: the extent is the path of the tool or, if that only turns, of the joints.
    const bool areOfTool = std::all_of(own.begin(), own.end(), isOfTool);
    double speed = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < own.size(); ++i) {
      extents.push_back(areOfTool ? own[i].length : leastDuration(points[i + 1] - points[i], most));
      if (extents[i] > 0.0 && durations[i] > 0.0) speed = std::min(speed, extents[i] / durations[i]);
    }
    if (!std::isfinite(speed)) speed = 1.0;
    m_runs.push_back({begin, TimedRun::stopping(points, extents, speed, most)});
  }
  double before = 0.0;
  for (std::size_t i = 0; i < extents.size(); ++i) {
    m_begins.push_back(i == 0 ? begin : begin + m_runs.back().motions.timeOf(before));
    m_runOf.push_back(m_runs.size() - 1);
    m_extents.push_back(extents[i]);
    m_extentsBefore.push_back(before);
    before += extents[i];
  }
}

std::size_t TimedPath::motionAt(double time) const {
  if (m_runs.empty()) return 0;
  const auto after = std::upper_bound(m_begins.begin() + 1, m_begins.end() - 1, time);
  return static_cast<std::size_t>(after - m_begins.begin()) - 1;
}

double TimedPath::shareAt(double time) const {
  if (m_runs.empty()) return 0.0;
  const std::size_t motion = motionAt(time);
  if (time >= m_begins[motion + 1] || !(m_extents[motion] > 0.0)) return 1.0;
  const Run& run = m_runs[m_runOf[motion]];
  return std::clamp((run.motions.extentAt(time - run.begin) - m_extentsBefore[motion]) / m_extents[motion], 0.0, 1.0);
}

ArmValues TimedPath::valuesAt(double time) const {
  assert(!m_path.empty());
  if (m_runs.empty()) return m_path.front();
  const std::size_t motion = motionAt(time);
  const Run& run = m_runs[m_runOf[motion]];
  // Stops are exactly at their waypoints.
  const bool isLastOfRun = motion + 1 == m_runOf.size() || m_runOf[motion + 1] != m_runOf[motion];
  if (isLastOfRun && time >= m_begins[motion + 1]) return m_path[motion + 1];
  return run.motions.valuesAt(run.motions.extentAt(time - run.begin));
}

}  // namespace handwheel
