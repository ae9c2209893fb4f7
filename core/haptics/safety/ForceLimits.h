// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/safety/SafetySettings.h"

namespace handwheel {

// Returns true if all components are finite.
bool isFinite(const DeviceForce& force);

// Limits the slew rate of the force. Moves from the force sent last towards the one asked for, by no more than the
// rates allow in `seconds`, on a straight line, so that the direction does not swing out.
DeviceForce slewed(const DeviceForce& last, const DeviceForce& asked, double seconds, const SafetySettings& settings);

// Clamps force and torque to the device's maximum, keeping their directions. The projection on a ball is non-expansive,
// so what was slew-limited stays slew-limited.
DeviceForce clamped(const DeviceForce& asked, const SafetySettings& settings);

}  // namespace handwheel
