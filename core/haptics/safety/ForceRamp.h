// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety/SafetySettings.h"

namespace handwheel {

// Ramps the force up from zero after a possible discontinuity. Examples are a model that was loaded, another tool, the
// clutch, a change of snapping, another mapping, and a fault. The ramp waits until the scene asks for a small force, as
// in free space, or for a limited time, and then rises linearly with time.
class ForceRamp {
 public:
  explicit ForceRamp(const SafetySettings& settings) : m_settings(settings) {}

  void restart();
  // Returns the gain of the force, 0 to 1. asked: the force from the scene, N. period: the time since the previous
  // tick, s.
  double gain(double asked, double period);

 private:
  enum class Phase { Waiting, Rising, Done };
  SafetySettings m_settings;
  Phase m_phase = Phase::Waiting;
  double m_time = 0.0;  // s, time since this phase began
};

}  // namespace handwheel
