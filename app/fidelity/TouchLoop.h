// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/BallTouch.h"
#include "haptics/HandPath.h"
#include "haptics/ServoLoop.h"

namespace handwheel {

// A ball, and a way below its surface, led along at 100 mm/s for so many seconds after the tip has come in from
// outside.
struct BallSlide {
  BallTouch ball;
  HandPath path;

  static constexpr double kArrival = 0.002;  // s, in which it comes in
};
BallSlide ballSlide(std::uint64_t seed, double seconds);

// A loop that feels the ball by a device which goes that way and does nothing else. Clock and service outlive it.
std::unique_ptr<ServoLoop> touchLoop(const BallSlide& slide, const ServoSettings& servo, ServoClock& clock,
                                     Service& service);

// us: the median of a tick of that loop, touching, when it runs on a thread of its own at so many Hz and sleeps in
// between. Longer than what ticks take one upon the other, as other work has meanwhile filled the caches and the
// processor has slowed down: the more, the longer it slept. Takes 0.6 s; 0 once cancelled, which it notices within 20
// ms.
double tickInUse(double rate, Progress progress);

}  // namespace handwheel
