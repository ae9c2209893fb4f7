// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/SimulatedDevice.h"

namespace handwheel {

// The force (N) of a simulated pressing hand. It begins to act when the force ramp is over; until then the tip rests in
// free space.
inline constexpr double kPressingForce = 2.0;

// Returns the final penetration (mm) of the simulated hand into a plane wall, averaged over a second. The wall has this
// stiffness (N/mm), or the greatest that the loop allows on this device at this rate (Hz) if that is lower. packets:
// the interval (s) between packets on the device's connection; 0: the position can be read at any time. A reading waits
// for the next packet; if the interval equals that of the ticks, the packet arrives midway between two ticks. Runs the
// servo loop on a simulated clock. The result is undefined if the call is cancelled.
double pressedDepth(const DeviceCapabilities& device, double rate, double stiffness, double packets = 0.0,
                    Progress progress = {});

}  // namespace handwheel
