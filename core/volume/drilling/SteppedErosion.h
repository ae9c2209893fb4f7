// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace handwheel {

// A hole like those in the figures of He (2008, 3.3). A ball passes through a plate at a constant feed. In each cycle
// of the servo loop, each voxel with its centre in the ball loses one step of its density.
struct SteppedHole {
  double diameter = 6.0;   // mm, diameter of the ball
  double voxel = 0.255;    // mm
  double feed = 1.0;       // mm/s
  double step = 1.0;       // Δs, in levels of density, of which there are 255
  double rate = 1000.0;    // Hz
  double thickness = 8.0;  // mm, thickness of the plate
};

// Returns true if all parameters are valid: they are above 0, with at most 255 levels per step, and at most 100 million
// voxels and cycles.
bool isDrillable(const SteppedHole& hole);

// Returns the volume removed in each cycle, mm³, from the contact of the ball until it has passed through the plate;
// this is MR of equation A-8 (He 2008). Each voxel is visited at the beginning and the end of its loss, so the time is
// proportional to the number of voxels plus the number of cycles, not to their product. The result is empty if the hole
// is not drillable.
std::vector<double> removedBySteps(const SteppedHole& hole);

}  // namespace handwheel
