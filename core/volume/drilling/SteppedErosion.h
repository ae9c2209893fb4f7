// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace handwheel {

// A hole as He (2008, 3.3) drills it for his figures. A ball goes through a plate at a constant feed. In each cycle of
// the servo loop a voxel of which the centre is in the ball loses one step of its density.
struct SteppedHole {
  double diameter = 6.0;   // mm, of the ball
  double voxel = 0.255;    // mm
  double feed = 1.0;       // mm/s
  double step = 1.0;       // Δs, of 255 levels
  double rate = 1000.0;    // Hz
  double thickness = 8.0;  // mm, of the plate
};

// Whether all of it are numbers that can be: above 0, at most 255 steps, and no more voxels and cycles than 100
// million.
bool isDrillable(const SteppedHole& hole);

// What each cycle removes, mm³, from the touch of the ball on until it is through; MR of A-8. Each voxel counts where
// it begins and where it ends to lose, so the time is that of the voxels and the cycles and not of their product. Of a
// hole that is not drillable: nothing.
std::vector<double> removedBySteps(const SteppedHole& hole);

}  // namespace handwheel
