// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SurfaceToVolume.h"

namespace handwheel {

// The methods that decide which fraction of a voxel is material.
enum class VoxelMethod {
  Sign,     // the distance from the surface, signed by winding numbers (volumeOfSurface())
  Density,  // the fraction of the voxel that is material
};

// Makes a volume of the fraction of each voxel that is inside a surface (He 2008, 5.2: anti-aliased density). The
// fraction is the mean length inside of rays along three axes, four per voxel and axis, in 1/255. The surface of the
// volume is where the fraction is one half. A point is inside if its winding number is at least one; all holes are
// closed by cones, and details thinner than a voxel are smoothed. The method is less exact than distances, as a density
// contains no information beyond its voxel. It is meant for comparison, and for noisy scans.
//
// voxel: size of a voxel, mm. Runs on all threads of the arena; O(area / voxel² + n log n). Returns the errors of
// volumeOfSurface().
Result<SurfaceVolume> volumeByDensity(const TriangleSoup& soup, double voxel, Progress progress = {});

// Makes a volume of a surface by the given method.
Result<SurfaceVolume> volumeOfSurface(const TriangleSoup& soup, double voxel, VoxelMethod method, Progress progress);

}  // namespace handwheel
