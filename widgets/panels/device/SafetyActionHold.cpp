// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/device/SafetyActionHold.h"

namespace handwheel {

SafetyActions SafetyActionHold::add(SafetyActions actions, double time) {
  const bool goesOn = time >= m_time;  // not so for NaN
  if (!goesOn) clear();
  const double passed = goesOn ? time - m_time : 0.0;
  SafetyActions shown;
  for (std::size_t bit = 0; bit < m_left.size(); ++bit) {
    const auto action = static_cast<SafetyAction>(1u << bit);
    m_left[bit] = actions.has(action) ? kHold : m_left[bit] - passed;
    if (m_left[bit] > 0.0) shown.add(action);
  }
  m_time = time;
  return shown;
}

}  // namespace handwheel
