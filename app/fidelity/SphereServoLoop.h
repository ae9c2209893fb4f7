// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/BumpySphere.h"
#include "haptics/device/PoseTrajectory.h"
#include "haptics/servo/ServoLoop.h"

namespace handwheel {

// A bumpy ball and a tip path below its surface. The tip comes in from outside, then moves along the path at 100 mm/s
// for a given time.
struct SphereContact {
  BumpySphere ball;
  PoseTrajectory path;

  static constexpr double kArrival = 0.002;  // s, duration of the approach
};
SphereContact ballSlide(std::uint64_t seed, double seconds);

// Creates a servo loop with the ball as scene and a device that follows the path. The clock and the service must
// outlive the loop.
std::unique_ptr<ServoLoop> sphereServoLoop(const SphereContact& slide, const ServoSettings& servo, ServoClock& clock,
                                           Service& service);

// Measures the median duration (us) of a tick in contact, in realistic use. The loop runs on a thread of its own at
// this rate (Hz) and sleeps between ticks. A tick takes longer after a pause, because other work has filled the caches
// and the processor has slowed down; the effect grows with the length of the pause. Takes 0.6 s. Returns 0 within 20 ms
// after it is cancelled.
double tickInUse(double rate, Progress progress);

}  // namespace handwheel
