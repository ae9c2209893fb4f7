// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/ForceRamp.h"
#include "haptics/PassivityControl.h"
#include "haptics/SafetySettings.h"
#include "haptics/SpeedLimit.h"
#include "haptics/Watchdog.h"

namespace handwheel {

// What a tick hands to the chain; all in the frame of the device.
struct SafetyInput {
  DeviceForce asked;
  Vec3 position = Vec3::Zero();  // mm
  Vec3 velocity = Vec3::Zero();  // mm/s
  double stepSpeed = 0.0;        // mm/s, of the way since the reading before alone: what a velocity evens out
  double period = 0.001;         // s since the tick before, > 0, as it was measured
  bool isDeviceReady = true;     // and what it says are numbers
  bool isFresh = true;           // the scene has given this force just now
  bool mayLeap = false;          // the scene, the tool, or the mapping is another
};

struct SafetyOutput {
  DeviceForce sent;
  SafetyActions actions;
  double energy = 0.0;  // N·mm, of the passivity observer
};

// Every force passes here on its way to the device, whatever has made it. Order: not finite to zero; passivity
// controller; damping of speed; ramp; watchdog; slew limit; clamp. A fault sends zero at once, past the slew limit, and
// the force comes back by the ramp. Servo thread; allocates nothing.
class SafetyChain {
 public:
  explicit SafetyChain(const SafetySettings& settings);

  // What to send. Finite and within the limits whatever the input is.
  SafetyOutput process(const SafetyInput& input) noexcept;

  const SafetySettings& settings() const { return m_settings; }

 private:
  SafetyOutput fault(SafetyAction why);
  void damp(const SafetyInput& input, DeviceForce& force, SafetyActions& actions);
  void scale(const SafetyInput& input, DeviceForce& force, SafetyActions& actions);

  SafetySettings m_settings;
  PassivityControl m_passivity;
  SpeedLimit m_speed;
  ForceRamp m_ramp;
  Watchdog m_watchdog;
  DeviceForce m_last;
};

}  // namespace handwheel
