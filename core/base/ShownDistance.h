// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace handwheel {

// The number of decimals to display for a guaranteed distance (mm).
inline int decimalsOfDistance(double distance) {
  return std::abs(distance) < 1.0 ? 3 : 1;
}

// Such a distance as it is shown: rounded down, so that it is never said to be more.
inline double shownDistance(double distance) {
  constexpr double kNoise = 1e-9;  // of computing, in the last decimal
  const double steps = std::pow(10.0, decimalsOfDistance(distance));
  return std::floor(distance * steps + kNoise) / steps;
}

}  // namespace handwheel
