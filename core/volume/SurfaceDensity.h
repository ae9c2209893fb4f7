// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SurfaceToVolume.h"

namespace handwheel {

// The methods that decide how much of a voxel is material.
enum class VoxelMethod {
  Sign,     // the distance from the surface, signed by winding numbers (volumeOfSurface())
  Density,  // the share of the voxel that is material
};

// Samples how much of each voxel is inside a surface (He 2008, 5.2: anti-aliased density): the mean over rays along
// three axes, four to a voxel and axis, of the length inside it, in 255ths. The surface is where half of a voxel is
// material. Inside is what the surface goes round at least once; all holes are closed by cones, and what is thinner
// than a voxel is smoothed over. Less exact than distances, as a density says nothing beyond its voxel: for comparison,
// and for scans whose noise it averages.
//
// voxel: mm. On all threads of the arena; O(area / voxel² + n log n). Errors: those of volumeOfSurface().
Result<SurfaceVolume> volumeByDensity(const TriangleSoup& soup, double voxel, Progress progress = {});

// By either method.
Result<SurfaceVolume> volumeOfSurface(const TriangleSoup& soup, double voxel, VoxelMethod method, Progress progress);

}  // namespace handwheel
