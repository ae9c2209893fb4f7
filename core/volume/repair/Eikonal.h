// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

// Returns the distance at a grid point from those of its neighbours along the axes. d: the smaller distance of the two
// neighbours on each axis, infinite if unknown. The function solves |gradient| = 1 with upwind differences (Rouy,
// Tourin 1992).
inline float eikonalDistance(std::array<float, 3> d) {
  std::sort(d.begin(), d.end());
  float x = d[0] + 1.0f;
  if (x > d[1]) {
    const float sum = d[0] + d[1], difference = d[0] - d[1];
    x = 0.5f * (sum + std::sqrt(std::max(0.0f, 2.0f - difference * difference)));
    if (x > d[2]) {
      // The distances are relative to the nearest neighbour, as squares of large distances would cancel.
      const float a = d[1] - d[0], b = d[2] - d[0], both = a + b;
      x = d[0] + (both + std::sqrt(std::max(0.0f, both * both - 3.0f * (a * a + b * b - 1.0f)))) / 3.0f;
    }
  }
  return x;
}

}  // namespace handwheel
