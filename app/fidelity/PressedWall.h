// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/SimulatedDevice.h"

namespace handwheel {

// With what a simulated hand presses (N), after its tip has rested in free space until the ramp of the force is over.
inline constexpr double kPressingForce = 2.0;

// How deep (mm) that hand is in a plane wall in the end, on a mean over a second: on this device, at so many ticks a
// second, in a wall of so many N/mm or as many as the loop allows. Where the wire of the device carries a packet every
// so many seconds (0: at any time), a reading waits for the next, which comes in the middle between ticks of the same
// rate. By the loop itself, on time of its own. Anything once cancelled.
double pressedDepth(const DeviceCapabilities& device, double rate, double stiffness, double packets = 0.0,
                    Progress progress = {});

}  // namespace handwheel
