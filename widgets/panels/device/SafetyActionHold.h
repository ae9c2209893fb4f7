// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety/SafetySettings.h"

#include <array>

namespace handwheel {

// A memory that holds each action of the safety chain long enough to be read. Most actions last only a few ticks.
class SafetyActionHold {
 public:
  static constexpr double kHold = 1.0;  // s

  // Adds the active actions and returns those that are active or were active within the last kHold. time: s since the
  // loop started; a time that goes back clears the memory.
  SafetyActions add(SafetyActions actions, double time);
  void clear() { m_left = {}; }

 private:
  std::array<double, 32> m_left{};  // remaining time for which each bit is shown, s
  double m_time = 0.0;
};

}  // namespace handwheel
