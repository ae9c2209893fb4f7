// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "haptics/SceneForces.h"
#include "haptics/ServoTick.h"

namespace handwheel {

// proxy.tolerance: below which share of the surface's diagonal a proxy is at rest (ContactOptions::tolerance).
FidelitySetting proxyToleranceSetting();

// servo.rate: ticks a second (ServoSettings::rate). A wall may be as stiff as the rate allows (eq. 2-1).
FidelitySetting servoRateSetting();

// contact.stiffness: N/mm of a touched surface. The device gives less where the loop cannot carry it.
FidelitySetting contactStiffnessSetting();

// servo.velocity_window: s, of positions that make a velocity (VelocityEstimator). Short, it is noisy; long, it is
// late.
FidelitySetting velocityWindowSetting();

// What was chosen, as the loop and the scene take it; both hold it from when they are made. Where nobody chose a rate,
// it is 0, the nominal one of each device.
ServoSettings servoSettings(const FidelityValues& values);
ContactOptions contactOptions(const FidelityValues& values);
SurfaceFeel surfaceFeel(ContactSurface surface, const FidelityValues& values);

}  // namespace handwheel
