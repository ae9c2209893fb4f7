// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

#include <cstdint>

namespace handwheel {

// Interventions of the safety chain, as bits in the order of its stages.
enum class SafetyAction : std::uint32_t {
  None = 0,
  DeviceFault = 1u << 0,   // the device is not ready, or its reading is not finite: no force
  NotFinite = 1u << 1,     // the scene asked for a force that is not finite: no force
  Passivity = 1u << 2,     // more energy came out than went in: damped
  SpeedDamping = 1u << 3,  // faster than normal hand motion: damped
  SpeedCut = 1u << 4,      // speed of a handle that was let go: no force
  Ramp = 1u << 5,          // rising slowly after a possible discontinuity
  Watchdog = 1u << 6,      // no new force from the scene, or a tick far too late: fading
  Slew = 1u << 7,          // rate of change limited
  Clamp = 1u << 8,         // magnitude limited to the device's maximum
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

// The limits of the safety chain, in the frame of the device. Times in s; a maximum of 0 means
// that the device has no motors for it (torque, gripper).
struct SafetySettings {
  double nominalPeriod = 0.001;

  double latency = 0.0;  // latency of the device, from a motion to its force response, without the loop's own

  double inherentDamping = 0.0;  // N·s/mm: b, the damping of the device itself
  double controlDamping = 0.0;   // N·s/mm: the most that the passivity controller adds; 0 switches it off
  double energyLimit = 0.0;      // N·mm: no more than this is credited, for no passive scene can store more

  double dampingSpeed = 1000.0;  // mm/s: damping sets in
  double cutSpeed = 3000.0;      // mm/s: force ends
  double speedDamping = 0.0;     // N·s/mm: reached at cutSpeed; also the damping that the watchdog leaves

  double rampTime = 1.0;       // from zero force to all of it
  double rampThreshold = 0.2;  // N: the ramp waits for a smaller force
  double rampWait = 1.0;       // longest wait for it

  double staleTime = 0.005;     // time that the last force of the scene is held in full
  double fadeTime = 0.005;      // time of the fade to damping alone
  double dampingTime = 0.1;     // time from then until damping ends, too
  double recoveryTime = 0.1;    // time to return to the full force when the scene responds again
  double slewRate = 2000.0;     // N/s: 2 N per ms. Must be above that of a wall contact, or it generates energy
  double torqueSlewRate = 0.0;  // N·mm/s
  double gripperSlewRate = 0.0;

  double maxForce = 0.0;   // N
  double maxTorque = 0.0;  // N·mm
  double maxGripperForce = 0.0;
};

// Derives the limits from the specifications of a device and the loop rate, Hz.
SafetySettings safetySettingsFor(const DeviceCapabilities& device, double rate);

}  // namespace handwheel
