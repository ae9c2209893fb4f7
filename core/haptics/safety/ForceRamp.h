// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety/SafetySettings.h"

namespace handwheel {

// Ramps the force up from zero after a possible discontinuity. Examples: a model loaded, another tool, the clutch,
// snapping switched, another mapping, a fault. It waits until the scene asks for a small force, as in free space, or
// for a limited time, and then rises linearly with time.
class ForceRamp {
 public:
  explicit ForceRamp(const SafetySettings& settings) : m_settings(settings) {}

  void restart();
  // Returns the gain of the force, 0 to 1. asked: N, the force from the scene; period: s since the previous tick.
  double gain(double asked, double period);

 private:
  enum class Phase { Waiting, Rising, Done };
  SafetySettings m_settings;
  Phase m_phase = Phase::Waiting;
  double m_time = 0.0;  // s, in this phase
};

}  // namespace handwheel
