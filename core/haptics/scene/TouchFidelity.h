// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "haptics/scene/SurfaceForce.h"
#include "haptics/servo/ServoTick.h"

namespace handwheel {

// Returns the setting proxy.tolerance: rest tolerance of a proxy (ContactOptions::tolerance). It is a share of the
// surface's diagonal.
FidelitySetting proxyToleranceSetting();

// Returns the setting servo.rate: ticks per second (ServoSettings::rate). It limits the stiffness of walls (eq. 2-1).
FidelitySetting servoRateSetting();

// Returns the setting contact.stiffness: stiffness of a touched surface, N/mm. It is reduced to the stiffness limit of
// the loop.
FidelitySetting contactStiffnessSetting();

// Returns the setting servo.velocity_window: window of the velocity estimate, s (VelocityEstimator). A short one is
// noisy, a long one lags.
FidelitySetting velocityWindowSetting();

// Convert the chosen values to settings of loop and scene. Both keep them from their creation on. If no rate was
// chosen, it is 0, the nominal one of each device.
ServoSettings servoSettings(const FidelityValues& values);
ContactOptions contactOptions(const FidelityValues& values);
TouchedSurface touchedSurface(ContactSurface surface, const FidelityValues& values);

}  // namespace handwheel
