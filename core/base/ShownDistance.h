// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace handwheel {

// Returns the number of decimals to display for a guaranteed distance, mm.
inline int decimalsOfDistance(double distance) {
  return std::abs(distance) < 1.0 ? 3 : 1;
}

// Rounds a guaranteed distance down for display, so that the displayed distance is never larger.
inline double shownDistance(double distance) {
  constexpr double kNoise = 1e-9;  // rounding error of the computation, in units of the last displayed decimal
  const double steps = std::pow(10.0, decimalsOfDistance(distance));
  return std::floor(distance * steps + kNoise) / steps;
}

}  // namespace handwheel
