// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/device/DeviceMotionEstimator.h"

#include <algorithm>

namespace handwheel {

namespace {
constexpr std::uint32_t kLargestBunch = 8;  // readings at once; more were not counted but started anew
}

DeviceMotionEstimator::Seen DeviceMotionEstimator::add(const DeviceState& state, double period) {
  m_time += period;
  Seen seen;
  seen.isNew = !m_hasReading || state.reading == 0 || state.reading != m_number;
  if (seen.isNew) {
    seen.stepSpeed = m_hasReading ? stepSpeed(state) : 0.0;
    const Vec3 estimated = m_estimator.add(state.position, m_time);
    m_velocity = state.hasVelocity ? state.velocity : estimated;
    m_position = state.position;
    m_number = state.reading;
    m_hasReading = true;
    m_time = 0.0;
  }
  if (m_time <= m_periods.stale) seen.velocity = m_velocity;
  return seen;
}

double DeviceMotionEstimator::stepSpeed(const DeviceState& state) const {
  const std::uint32_t bunch = state.reading == 0 ? 1 : std::min(state.reading - m_number, kLargestBunch);
  const double least = std::max(m_periods.loop, bunch * m_periods.device);
  return (state.position - m_position).norm() / std::max(m_time, least);
}

void DeviceMotionEstimator::reset() {
  m_estimator.reset();
  m_velocity.setZero();
  m_time = 0.0;
  m_hasReading = false;
}

}  // namespace handwheel
