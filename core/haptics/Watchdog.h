// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/SafetySettings.h"

namespace handwheel {

// Fades the force when the scene has said nothing new for a while, or when the loop itself came far too late: the last
// word is held, then fades to damping alone, then to nothing. Back again slowly.
class Watchdog {
 public:
  explicit Watchdog(const SafetySettings& settings) : m_settings(settings) {}

  struct Gains {
    double force = 1.0;    // of what the scene asks
    double damping = 0.0;  // of speedDamping, in the place of what was taken
  };
  // For a tick that came so many seconds after the one before, with or without news from the scene.
  Gains tick(double period, bool isFresh);
  void reset() { *this = Watchdog(m_settings); }

 private:
  SafetySettings m_settings;
  double m_stale = 0.0;  // s without news
  double m_force = 1.0;
};

}  // namespace handwheel
