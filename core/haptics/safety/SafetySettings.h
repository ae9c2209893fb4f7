// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

#include <cstdint>

namespace handwheel {

// Interventions of the safety chain, as bits in the order of its stages.
enum class SafetyAction : std::uint32_t {
  None = 0,
  DeviceFault = 1u << 0,   // the device is not ready, or its reading is not finite; no force is sent
  NotFinite = 1u << 1,     // the scene asked for a force that is not finite; no force is sent
  Passivity = 1u << 2,     // more energy came out than went in; the motion is damped
  SpeedDamping = 1u << 3,  // the speed exceeds that of normal hand motion; the motion is damped
  SpeedCut = 1u << 4,      // the speed is that of a handle that was let go; no force is sent
  Ramp = 1u << 5,          // the force rises slowly after a possible discontinuity
  Watchdog = 1u << 6,      // the scene computed no new force, or a tick came far too late; the force fades
  Slew = 1u << 7,          // the rate of change of the force was limited
  Clamp = 1u << 8,         // the force was limited to the maximum of the device
};

// A set of safety actions.
class SafetyActions {
 public:
  void add(SafetyAction action) { m_bits |= static_cast<std::uint32_t>(action); }
  bool has(SafetyAction action) const { return (m_bits & static_cast<std::uint32_t>(action)) != 0; }
  bool isEmpty() const { return m_bits == 0; }
  std::uint32_t bits() const { return m_bits; }

 private:
  std::uint32_t m_bits = 0;
};

// The limits of the safety chain, in the frame of the device. Times are in s. A maximum of 0 means that the device has
// no motors for torque or gripper.
struct SafetySettings {
  double nominalPeriod = 0.001;

  double latency = 0.0;  // latency of the device from a motion to its force response, without that of the loop

  double inherentDamping = 0.0;  // N·s/mm: b, the inherent damping of the device
  double controlDamping = 0.0;   // N·s/mm: largest damping by the passivity controller; 0: it is off
  double energyLimit = 0.0;      // N·mm: largest energy that is credited, since no passive scene can store more

  double dampingSpeed = 1000.0;  // mm/s: speed at which damping begins
  double cutSpeed = 3000.0;      // mm/s: speed at which the force is cut
  double speedDamping = 0.0;     // N·s/mm: damping at cutSpeed, and damping that the watchdog leaves

  double rampTime = 1.0;       // time in which the force rises from zero to its full value
  double rampThreshold = 0.2;  // N: the ramp waits for a smaller force
  double rampWait = 1.0;       // longest time that the ramp waits

  double staleTime = 0.005;   // time for which the last force of the scene is held in full
  double fadeTime = 0.005;    // time in which the force fades to damping alone
  double dampingTime = 0.1;   // time from the end of the fade until the damping ends
  double recoveryTime = 0.1;  // time in which the full force returns when the scene responds again
  double slewRate = 2000.0;   // N/s: 2 N per ms; must exceed the rate of a wall contact, or the limit generates energy
  double torqueSlewRate = 0.0;  // N·mm/s
  double gripperSlewRate = 0.0;

  double maxForce = 0.0;   // N
  double maxTorque = 0.0;  // N·mm
  double maxGripperForce = 0.0;
};

// Derives the limits from the specifications of a device and the loop rate, Hz.
SafetySettings safetySettingsFor(const DeviceCapabilities& device, double rate);

}  // namespace handwheel
