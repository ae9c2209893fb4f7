// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "volume/SparseVolume.h"

namespace handwheel {

// Resamples a volume on another grid. The centre of a voxel is at origin (mm); voxel: its edge (mm, above 0). Depths
// are interpolated linearly between eight samples; in coarser voxels they are made distances again, step by step, each
// at most twice as coarse. What is thinner than a voxel may vanish. Where the grids differ by whole blocks, the blocks
// are shared and nothing is interpolated. On all threads of the arena; O(blocks of the result near the surface).
//
// Errors: VolumeErrors::TooFine (further away than a volume goes), TooLarge (for the memory that is left); Cancelled.
Result<SparseVolume> resampled(const SparseVolume& volume, const Vec3& origin, double voxel, Progress progress = {});

}  // namespace handwheel
