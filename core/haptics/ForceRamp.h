// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/SafetySettings.h"

namespace handwheel {

// Lets the force rise from nothing after anything that could make it leap: a model loaded, another tool, the clutch,
// snapping switched, another mapping, a fault. It waits until the scene asks for little, as in free space, or for a
// time, and then rises in proportion to time.
class ForceRamp {
 public:
  explicit ForceRamp(const SafetySettings& settings) : m_settings(settings) {}

  void restart();
  // The share of the force that may be sent, 0 to 1, when the scene asks for so many newtons after so many seconds.
  double gain(double asked, double period);

 private:
  enum class Phase { Waiting, Rising, Done };
  SafetySettings m_settings;
  Phase m_phase = Phase::Waiting;
  double m_time = 0.0;  // s, in this phase
};

}  // namespace handwheel
