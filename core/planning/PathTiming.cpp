// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PathTiming.h"

#include <algorithm>
#include <cassert>
#include <cmath>

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

TimedPath::TimedPath(const RobotScene& scene, JointPath path, const PathTimingSettings& settings,
                     std::span<const double> speeds)
    : m_path(std::move(path)) {
  m_begins.push_back(0.0);
  for (std::size_t i = 1; i < m_path.size(); ++i) {
    constexpr double kFastest = 1e12;  // shares of a motion per s: of one that does not move anything
    double velocity = kFastest;
    for (Eigen::Index k = 0; k < scene.size(); ++k) {
      const ArmJoint& joint = scene.joint(k);
      const double way = std::abs(m_path[i][k] - m_path[i - 1][k]);
      const double known = joint.velocity.value_or(0.0) > 0.0 ? *joint.velocity
                           : joint.isPrismatic                ? settings.sliding
                                                              : settings.turning;
      if (way > 0.0) velocity = std::min(velocity, known / way);
    }
    const double own = i - 1 < speeds.size() ? speeds[i - 1] : 1.0;
    const double acceleration = velocity / settings.timeToSpeed;
    const bool moves = velocity < kFastest;
    velocity *= std::clamp(settings.speed * own, 1e-3, 1.0);
    m_motions.emplace_back(moves ? 1.0 : 0.0, velocity, acceleration, acceleration / settings.timeToRamp);
    m_begins.push_back(m_begins.back() + m_motions.back().duration());
  }
}

std::size_t TimedPath::motionAt(double time) const {
  if (m_motions.empty()) return 0;
  const auto after = std::upper_bound(m_begins.begin() + 1, m_begins.end() - 1, time);
  return static_cast<std::size_t>(after - m_begins.begin()) - 1;
}

double TimedPath::shareAt(double time) const {
  if (m_motions.empty()) return 0.0;
  const std::size_t motion = motionAt(time);
  return time >= m_begins[motion + 1] ? 1.0 : m_motions[motion].at(time - m_begins[motion]);
}

ArmValues TimedPath::valuesAt(double time) const {
  assert(!m_path.empty());
  if (m_motions.empty()) return m_path.front();
  const std::size_t motion = motionAt(time);
  const double share = shareAt(time);
  if (share >= 1.0) return m_path[motion + 1];
  return m_path[motion] + share * (m_path[motion + 1] - m_path[motion]);
}

}  // namespace handwheel
