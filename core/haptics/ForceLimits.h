// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/SafetySettings.h"

namespace handwheel {

bool isFinite(const DeviceForce& force);

// Moves from the force sent last towards the one asked for, by no more than the rates allow in so many seconds, and on
// the straight way: its direction does not swing out.
DeviceForce slewed(const DeviceForce& last, const DeviceForce& asked, double seconds, const SafetySettings& settings);

// Shortens force and torque, each in its direction, to what the device may give. It brings no two forces further apart
// (projection on a ball), so what was slewed stays slewed.
DeviceForce clamped(const DeviceForce& asked, const SafetySettings& settings);

}  // namespace handwheel
