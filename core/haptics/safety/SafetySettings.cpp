// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety/SafetySettings.h"

#include "haptics/safety/StiffnessLimit.h"

#include <algorithm>
#include <limits>

namespace handwheel {

SafetySettings safetySettingsFor(const DeviceCapabilities& device, double rate) {
  SafetySettings s;
  s.nominalPeriod = 1.0 / rate;
  // If a driver states none, the damping that its stated stiffness needs at its nominal rate is taken (eq. 2-1).
  s.inherentDamping =
      device.inherentDamping > 0.0 ? device.inherentDamping : 0.5 * device.maxStiffness / device.nominalRate;
  // Late damping may push: below b it never makes more than the friction takes (Cauchy and Schwarz, again).
  s.latency = device.latency;
  s.controlDamping =
      device.latency < s.nominalPeriod ? device.maxDamping : std::min(device.maxDamping, s.inherentDamping);
  // A conservative field of forces up to maxForce holds no more than this across the workspace.
  s.energyLimit = 2.0 * device.maxForce * device.workspaceRadius;
  // A velocity is always estimated late, by half the filter's window.
  s.speedDamping = std::min(device.maxDamping, s.inherentDamping);
  // A device that only points may be thrown across the scene: nothing can get loose.
  if (device.outputs == 0) s.dampingSpeed = s.cutSpeed = std::numeric_limits<double>::infinity();
  // The slew rate reaches full force in 4 ms at least, and is never below that at the stiffest wall that the loop
  // allows, met as fast as possible before damping sets in. A lower limit would lag behind the wall and give back more
  // than it took.
  const double full = 0.004;
  const double allowed = stiffnessLimit({s.nominalPeriod, device.latency, s.inherentDamping}, 0.0);
  const double stiffest = device.maxStiffness > 0.0 ? std::min(device.maxStiffness, allowed) : allowed;
  s.slewRate = std::max(device.maxForce / full, device.outputs > 0 ? stiffest * s.dampingSpeed : 0.0);
  s.torqueSlewRate = device.maxTorque / full;
  s.gripperSlewRate = device.maxGripperForce / full;
  s.maxForce = device.maxForce;
  s.maxTorque = device.maxTorque;
  s.maxGripperForce = device.maxGripperForce;
  return s;
}

}  // namespace handwheel
