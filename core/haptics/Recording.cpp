// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/Recording.h"

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

}  // namespace handwheel
