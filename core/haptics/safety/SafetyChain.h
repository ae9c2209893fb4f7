// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety/ForceRamp.h"
#include "haptics/safety/PassivityControl.h"
#include "haptics/safety/SafetySettings.h"
#include "haptics/safety/SpeedLimit.h"
#include "haptics/safety/Watchdog.h"

namespace handwheel {

// Input of the safety chain for one tick, in device coordinates.
struct SafetyInput {
  DeviceForce asked;
  Vec3 position = Vec3::Zero();  // mm
  Vec3 velocity = Vec3::Zero();  // mm/s
  double stepSpeed = 0.0;        // mm/s, speed from the previous reading to this one, without smoothing
  double period = 0.001;         // measured time since the previous tick, s, > 0
  bool isDeviceReady = true;     // the device is ready and its readings are finite
  bool isFresh = true;           // the scene has computed this force in this tick
  bool isDiscontinuous = false;  // the scene, the tool, or the mapping has changed
};

// Output of the safety chain for one tick.
struct SafetyOutput {
  DeviceForce sent;
  SafetyActions actions;
  double energy = 0.0;  // N·mm, energy observed by the passivity observer
};

// Limits every force before it is sent to the device. The stages are, in this order: replacement of non-finite forces
// by zero; passivity controller; damping of speed; ramp; watchdog; slew limit; clamp. After a fault, zero is sent at
// once, bypassing the slew limit, and the force returns by the ramp. The chain is used on the servo thread, and does
// not allocate.
class SafetyChain {
 public:
  explicit SafetyChain(const SafetySettings& settings);

  // Computes the force to send. The force is finite and within the limits for any input.
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
