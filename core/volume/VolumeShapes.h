// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

namespace handwheel {

// A solid ball; lengths are in mm.
struct SolidBall {
  Vec3 centre = Vec3::Zero();
  double radius = 0.0;
  bool operator==(const SolidBall&) const = default;
};

// Returns the volume of a ball around the origin. Lengths are in mm, and voxel must be above 0. O(blocks of its
// bounding box).
SparseVolume ballOfVoxels(double radius, double voxel);

}  // namespace handwheel
