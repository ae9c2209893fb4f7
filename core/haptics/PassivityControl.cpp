// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/PassivityControl.h"

#include <algorithm>

namespace handwheel {

void PassivityControl::observe(const Vec3& position, double period) {
  if (m_hasPosition) {
    const Vec3 step = position - m_position;
    // In free space there is no credit to gather but that of the last step, which pays for entering a wall; a deficit
    // is what the device's friction has not yet taken back. In contact a cap, lest long sliding hides what comes later.
    if (m_held.isZero(0.0)) m_energy = std::min(m_energy, 0.0);
    m_energy += -m_held.dot(step) + m_settings.inherentDamping * step.squaredNorm() / period;
    m_energy = std::min(m_energy, m_settings.energyLimit);
    m_velocity = step / period;
  }
  m_position = position;
  m_hasPosition = true;
}

Vec3 PassivityControl::correction() const {
  const double power = m_velocity.squaredNorm() * m_settings.nominalPeriod;  // mm²/s: of a damping of 1 in one period
  if (m_energy >= 0.0 || power == 0.0) return Vec3::Zero();
  const double damping = std::min(-m_energy / power, m_settings.controlDamping);
  return -damping * m_velocity;
}

}  // namespace handwheel
