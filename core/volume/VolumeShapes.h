// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

namespace handwheel {

// A ball at a place; mm.
struct SolidBall {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
  bool operator==(const SolidBall&) const = default;
};

// A ball around the origin; mm. The voxel must be above 0. O(blocks of the box around it).
SparseVolume ballOfVoxels(double radius, double voxel);

}  // namespace handwheel
