// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety/ForceRamp.h"

#include <algorithm>

namespace handwheel {

void ForceRamp::restart() {
  m_phase = Phase::Waiting;
  m_time = 0.0;
}

double ForceRamp::gain(double asked, double period) {
  if (m_phase == Phase::Done) return 1.0;
  // A late tick makes no step of the ramp larger than two that come in time.
  m_time += std::min(period, 2.0 * m_settings.nominalPeriod);
  if (m_phase == Phase::Waiting) {
    if (asked >= m_settings.rampThreshold && m_time < m_settings.rampWait) return 0.0;
    m_phase = Phase::Rising;
    m_time = 0.0;
  }
  if (m_time < m_settings.rampTime) return m_time / m_settings.rampTime;
  m_phase = Phase::Done;
  return 1.0;
}

}  // namespace handwheel
