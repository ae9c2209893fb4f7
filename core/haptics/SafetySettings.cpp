// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/SafetySettings.h"

#include <algorithm>
#include <limits>

namespace handwheel {

SafetySettings safetySettingsFor(const DeviceCapabilities& device, double rate) {
  SafetySettings s;
  s.nominalPeriod = 1.0 / rate;
  // Where a driver states none, that which the stiffness its maker promises needs at its nominal rate (eq. 2-1).
  s.inherentDamping =
      device.inherentDamping > 0.0 ? device.inherentDamping : 0.5 * device.maxStiffness / device.nominalRate;
  // Damping that comes late may push: below b it never makes more than the friction takes (Cauchy and Schwarz, again).
  s.latency = device.latency;
  s.controlDamping =
      device.latency < s.nominalPeriod ? device.maxDamping : std::min(device.maxDamping, s.inherentDamping);
  // A conservative field of forces up to maxForce holds no more than this across the workspace.
  s.energyLimit = 2.0 * device.maxForce * device.workspaceRadius;
  s.speedDamping = std::min(0.5 * device.maxDamping, s.controlDamping);
  // What only points may be thrown across the scene: nothing can get loose.
  if (device.outputs == 0) s.dampingSpeed = s.cutSpeed = std::numeric_limits<double>::infinity();
  // In 4 ms to full force: at 8 N what a wall of 2 N/mm gives to a hand of 1 m/s.
  const double full = 0.004;
  s.slewRate = device.maxForce / full;
  s.torqueSlewRate = device.maxTorque / full;
  s.gripperSlewRate = device.maxGripperForce / full;
  s.maxForce = device.maxForce;
  s.maxTorque = device.maxTorque;
  s.maxGripperForce = device.maxGripperForce;
  return s;
}

}  // namespace handwheel
