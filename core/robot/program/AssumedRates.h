// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace handwheel {

// Rates of joints that descriptions of robots do not give, for the times of paths.
struct AssumedRates {
  double turning = M_PI;      // rad/s: velocity of revolute joints whose velocity is unknown or 0
  double sliding = 500.0;     // mm/s: velocity of slides whose velocity is unknown or 0
  double timeToSpeed = 0.25;  // s from rest to the largest velocity; determines the acceleration, whatever the speed
  double timeToRamp = 0.1;    // s until the full acceleration; determines the jerk

  bool operator==(const AssumedRates&) const = default;
};

}  // namespace handwheel
