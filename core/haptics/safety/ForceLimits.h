// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety/SafetySettings.h"

namespace handwheel {

// Returns true if all components of force, torque and gripper force are finite.
bool isFinite(const DeviceForce& force);

// Limits the slew rate of the force. Returns a force between the force sent last and the force asked for, no farther
// from the former than the rates allow in `seconds`. The change is along a straight line, so that the result lies
// between the two forces.
DeviceForce slewed(const DeviceForce& last, const DeviceForce& asked, double seconds, const SafetySettings& settings);

// Clamps force and torque to the maximum of the device, keeping their directions. The projection onto a ball is
// non-expansive, so the slew rate of the result is also limited.
DeviceForce clamped(const DeviceForce& asked, const SafetySettings& settings);

}  // namespace handwheel
