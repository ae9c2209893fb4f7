// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/repair/VolumeRepair.h"

#include <cstddef>

namespace handwheel {

// The work of a repair by volume, as predicted from the surface alone.
struct RepairWork {
  double sampled = 0.0;    // triangles of the volume's surface, before the reduction
  double triangles = 0.0;  // triangles of the result
};
// Predicts the work for a surface of this area (mm²) and number of triangles. Both numbers are right to a factor of two
// if the surface is smooth at the scale of a few voxels, and no wall is lost.
RepairWork predictedRepairWork(double area, std::size_t triangles, const VolumeRepairOptions& options);

// Predicts the time of the repair on this machine, with the comparison of the result, in s.
double predictedRepairSeconds(double area, std::size_t triangles, const VolumeRepairOptions& options);

// Measures how fast this machine repairs, by the repair of a small ball, which takes some tenths of a second once.
// Until then, predictions of the time are those of the machine on which the constants were measured.
void measureRepairSpeed();

}  // namespace handwheel
