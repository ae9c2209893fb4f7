// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/RestToRest.h"

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

double RestToRest::timeOf(double distance) const {
  double before = 0.0, after = duration();
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (before + after);
    (at(middle) < distance ? before : after) = middle;
  }
  return 0.5 * (before + after);
}

}  // namespace handwheel
