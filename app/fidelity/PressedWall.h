// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/SimulatedDevice.h"

namespace handwheel {

// The force (N) of a simulated pressing hand. It acts after the tip has rested in free space until the force ramp is
// over.
inline constexpr double kPressingForce = 2.0;

// Returns the final penetration (mm) of the simulated hand into a plane wall, averaged over a second. The wall has this
// stiffness (N/mm), or the stiffest that the loop allows on this device at this rate (Hz). packets: the interval (s)
// between packets on the device's connection (0: at any time); a reading waits for the next, which arrives in the
// middle between ticks of the same rate. Runs the servo loop itself on a simulated clock. The result is undefined once
// cancelled.
double pressedDepth(const DeviceCapabilities& device, double rate, double stiffness, double packets = 0.0,
                    Progress progress = {});

}  // namespace handwheel
