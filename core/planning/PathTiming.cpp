// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PathTiming.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace handwheel {

RestToRest::RestToRest(double distance, double velocity, double acceleration, double jerk)
    : m_distance(distance), m_jerk(jerk) {
  assert(distance >= 0.0 && velocity > 0.0 && acceleration > 0.0 && jerk > 0.0);
  if (distance <= 0.0) return;
  const bool reachesAcceleration = velocity * jerk >= acceleration * acceleration;
  m_turn = reachesAcceleration ? acceleration / jerk : std::sqrt(velocity / jerk);
  m_ramp = reachesAcceleration ? m_turn + velocity / acceleration : 2.0 * m_turn;
  m_cruise = distance / velocity - m_ramp;
  if (m_cruise >= 0.0) return;
  // The largest velocity is not reached.
  m_cruise = 0.0;
  if (distance >= 2.0 * acceleration * acceleration * acceleration / (jerk * jerk)) {
    m_turn = acceleration / jerk;
    m_ramp = 0.5 * m_turn + std::sqrt(0.25 * m_turn * m_turn + distance / acceleration);
  } else {
    m_turn = std::cbrt(distance / (2.0 * jerk));
    m_ramp = 2.0 * m_turn;
  }
}

double RestToRest::rampAt(double time) const {
  const double acceleration = m_jerk * m_turn, velocity = acceleration * (m_ramp - m_turn);
  if (time < m_turn) return m_jerk * time * time * time / 6.0;
  if (time < m_ramp - m_turn) return acceleration * (3.0 * time * (time - m_turn) + m_turn * m_turn) / 6.0;
  const double left = m_ramp - time;
  return 0.5 * velocity * m_ramp - velocity * left + m_jerk * left * left * left / 6.0;
}

double RestToRest::at(double time) const {
  if (!(time > 0.0)) return 0.0;
  if (time >= duration()) return m_distance;
  if (time <= m_ramp) return rampAt(time);
  if (time >= m_ramp + m_cruise) return m_distance - rampAt(duration() - time);
  const double velocity = m_jerk * m_turn * (m_ramp - m_turn);
  return 0.5 * velocity * m_ramp + velocity * (time - m_ramp);
}

double RestToRest::timeOf(double distance) const {
  double before = 0.0, after = duration();
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (before + after);
    (at(middle) < distance ? before : after) = middle;
  }
  return 0.5 * (before + after);
}

namespace {

// Returns the largest joint speed for a motion, in shares of it per second; infinity: nothing moves.
double largestShares(const RobotScene& scene, const ArmValues& displacement, const PathTimingSettings& settings) {
  double shares = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < scene.size(); ++k) {
    const ArmJoint& joint = scene.joint(k);
    const double known = joint.velocity.value_or(0.0) > 0.0 ? *joint.velocity
                         : joint.isPrismatic                ? settings.sliding
                                                            : settings.turning;
    if (displacement[k] != 0.0) shares = std::min(shares, known / std::abs(displacement[k]));
  }
  return shares;
}

// Returns true if the distance of the motion is in mm of the tool, and false if it is a share.
bool isOfTool(const MotionPace& pace) {
  return pace.length > 0.0 && pace.toolSpeed > 0.0;
}

}  // namespace

TimedPath::TimedPath(const RobotScene& scene, JointPath path, const PathTimingSettings& settings,
                     std::span<const MotionPace> paces)
    : m_path(std::move(path)) {
  constexpr double kSlowest = 1e-3;  // share of the largest velocities
  const auto paceOf = [&](std::size_t motion) { return motion < paces.size() ? paces[motion] : MotionPace{}; };
  const std::size_t count = m_path.empty() ? 0 : m_path.size() - 1;
  double time = 0.0;
  for (std::size_t first = 0, end = 0; first < count; first = end) {
    // The slowest joint limits the whole run.
    double largest = std::numeric_limits<double>::infinity(), wanted = largest, distance = 0.0;
    for (bool isOn = true; isOn && end < count; ++end) {
      const MotionPace pace = paceOf(end);
      if (end > first && !isOfTool(pace)) break;
      const double own = isOfTool(pace) ? pace.length : 1.0;
      const double joints = own * largestShares(scene, m_path[end + 1] - m_path[end], settings);
      largest = std::min(largest, joints);
      wanted = std::min(wanted, isOfTool(pace) ? pace.toolSpeed : joints * std::clamp(pace.speed, kSlowest, 1.0));
      m_distances.push_back(own);
      m_distancesBefore.push_back(distance);
      m_runOf.push_back(m_runs.size());
      distance += own;
      isOn = isOfTool(pace) && pace.isContinued;
    }
    if (!std::isfinite(largest)) {  // nothing moves
      m_runs.push_back({first, time, RestToRest(0.0, 1.0, 1.0, 1.0)});
    } else {
      const double acceleration = largest / settings.timeToSpeed;
      const double velocity = std::max(std::min(wanted, largest) * std::clamp(settings.speed, kSlowest, 1.0),
                                       kSlowest * std::min(wanted, largest));
      m_runs.push_back({first, time, RestToRest(distance, velocity, acceleration, acceleration / settings.timeToRamp)});
    }
    const RestToRest& profile = m_runs.back().profile;
    for (std::size_t motion = first; motion < end; ++motion)
      m_begins.push_back(motion == first ? time : time + profile.timeOf(m_distancesBefore[motion]));
    time += profile.duration();
  }
  m_begins.push_back(time);
}

std::size_t TimedPath::motionAt(double time) const {
  if (m_runs.empty()) return 0;
  const auto after = std::upper_bound(m_begins.begin() + 1, m_begins.end() - 1, time);
  return static_cast<std::size_t>(after - m_begins.begin()) - 1;
}

double TimedPath::shareAt(double time) const {
  if (m_runs.empty()) return 0.0;
  const std::size_t motion = motionAt(time);
  if (time >= m_begins[motion + 1]) return 1.0;
  const Run& run = m_runs[m_runOf[motion]];
  return std::clamp((run.profile.at(time - run.begin) - m_distancesBefore[motion]) / m_distances[motion], 0.0, 1.0);
}

ArmValues TimedPath::valuesAt(double time) const {
  assert(!m_path.empty());
  if (m_runs.empty()) return m_path.front();
  const std::size_t motion = motionAt(time);
  const double share = shareAt(time);
  if (share >= 1.0) return m_path[motion + 1];
  return m_path[motion] + share * (m_path[motion + 1] - m_path[motion]);
}

}  // namespace handwheel
