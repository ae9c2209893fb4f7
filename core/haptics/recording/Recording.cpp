// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/recording/Recording.h"

#include <algorithm>

namespace handwheel {

RecordedTick recorded(const ServoSample& sample) {
  return {sample.tick,           sample.tip,          sample.felt,          sample.sent,     sample.device.position,
          sample.actions.bits(), sample.microseconds, sample.device.status, sample.hasSource};
}

void Recording::add(const RecordedTick& tick) {
  if (size() > 0) {
    const std::uint64_t next = m_ticks[size() - 1].tick + 1;
    if (tick.tick > next) m_missing += tick.tick - next;
  }
  m_ticks.push_back(tick);
}

void Recording::append(const Recording& later) {
  for (std::size_t i = 0; i < later.size(); ++i) add(later[i]);
  m_events.insert(m_events.end(), later.m_events.begin(), later.m_events.end());
}

double Recording::duration() const {
  return m_ticks.empty() ? 0.0 : std::max(0.0, m_ticks[size() - 1].tip.time - m_ticks[0].tip.time);
}

}  // namespace handwheel
