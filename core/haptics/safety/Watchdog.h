// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety/SafetySettings.h"

namespace handwheel {

// Fades the force out when the scene or the loop does not respond. If the scene has computed no new force for a while,
// or a tick came far too late, the last force is held. It then fades to damping alone, and then to zero. When the scene
// responds again, the force returns slowly.
class Watchdog {
 public:
  explicit Watchdog(const SafetySettings& settings) : m_settings(settings) {}

  // Gain factors for one tick.
  struct Gains {
    double force = 1.0;    // factor of the scene's force
    double damping = 0.0;  // factor of speedDamping, which replaces the force that was removed
  };
  // Computes the gains of a tick. period: the time since the previous tick, s. isFresh: true if the scene computed a
  // new force.
  Gains tick(double period, bool isFresh);
  void reset() { *this = Watchdog(m_settings); }

 private:
  SafetySettings m_settings;
  double m_stale = 0.0;  // time without a new force, s
  double m_force = 1.0;
};

}  // namespace handwheel
