// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "haptics/scene/SurfaceForce.h"
#include "haptics/servo/ServoTick.h"

namespace handwheel {

// Returns the setting proxy.tolerance: the rest tolerance of a proxy (ContactOptions::tolerance). It is a fraction of
// the diagonal of the surface.
FidelitySetting proxyToleranceSetting();

// Returns the setting servo.rate: the number of ticks per second (ServoSettings::rate). It limits the stiffness of
// walls (He 2008, eq. 2-1).
FidelitySetting servoRateSetting();

// Returns the setting contact.stiffness: the stiffness of a touched surface, N/mm. The servo loop reduces it to its
// stiffness limit.
FidelitySetting contactStiffnessSetting();

// Returns the setting servo.velocity_window: the window of the velocity estimate, s (VelocityEstimator). With a short
// window the estimate is noisy, with a long window it lags.
FidelitySetting velocityWindowSetting();

// Convert the chosen values to settings of the loop and the scene, which keep them from their creation on. If no rate
// was chosen, the rate is 0, which means the nominal rate of each device.
ServoSettings servoSettings(const FidelityValues& values);
ContactOptions contactOptions(const FidelityValues& values);
TouchedSurface touchedSurface(ContactSurface surface, const FidelityValues& values);

}  // namespace handwheel
