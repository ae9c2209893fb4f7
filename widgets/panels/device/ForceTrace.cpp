// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/ForceTrace.h"

#include <cmath>

namespace handwheel {

void ForceTrace::add(const Point& point) {
  static_assert(kSeconds / kSpacing + 2.0 < std::tuple_size_v<decltype(m_ring)>);
  if (!std::isfinite(point.time)) return;
  if (m_count > 0 && point.time < last().time) clear();
  if (m_count > 0 && point.time - last().time < kSpacing) {
    Point& present = m_ring[(m_first + m_count - 1) % m_ring.size()];
    present.asked = std::fmax(present.asked, point.asked);  // a NaN is ignored
    present.sent = std::fmax(present.sent, point.sent);
    return;
  }
  while (m_count > 0 && point.time - at(0).time > kSeconds) {
    m_first = (m_first + 1) % m_ring.size();
    --m_count;
  }
  m_ring[(m_first + m_count++) % m_ring.size()] = point;
}

bool ForceTrace::isStill() const {
  if (m_count == 0 || last().time - at(0).time < kSeconds - 2.0 * kSpacing) return false;
  for (std::size_t i = 0; i + 1 < m_count; ++i) {
    if (at(i).asked != last().asked || at(i).sent != last().sent) return false;
  }
  return true;
}

}  // namespace handwheel
