// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety/Watchdog.h"

#include <algorithm>

namespace handwheel {

Watchdog::Gains Watchdog::tick(double period, bool isFresh) {
  const double onTime = std::min(period, 2.0 * m_settings.nominalPeriod);
  // With a new force only the lateness of this tick counts.
  m_stale = isFresh ? period - onTime : m_stale + period;
  const double over = m_stale - m_settings.staleTime;
  const double allowed = over <= 0.0 ? 1.0 : std::max(0.0, 1.0 - over / m_settings.fadeTime);
  m_force = std::min(allowed, m_force + onTime / m_settings.recoveryTime);
  const bool isSilent = over > m_settings.fadeTime + m_settings.dampingTime;
  return {m_force, isSilent ? 0.0 : 1.0 - m_force};
}

}  // namespace handwheel
