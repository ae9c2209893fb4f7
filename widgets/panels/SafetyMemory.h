// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/SafetySettings.h"

#include <array>

namespace handwheel {

// Keeps what the safety chain has done for as long as it takes to read it: most of it lasts a few ticks.
class SafetyMemory {
 public:
  static constexpr double kHold = 1.0;  // s

  // What acts now or did within the hold. The time in s, since the loop started; one that goes back starts anew.
  SafetyActions add(SafetyActions actions, double time);
  void clear() { m_left = {}; }

 private:
  std::array<double, 32> m_left{};  // s for which each bit is still to be shown
  double m_time = 0.0;
};

}  // namespace handwheel
