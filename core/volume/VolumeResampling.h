// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "volume/SparseVolume.h"

namespace handwheel {

// Resamples a volume on another grid. origin: the centre of any voxel, mm. voxel: its edge length, mm, above 0. Depths
// are interpolated linearly between eight samples; for coarser voxels, they are converted back to distances in steps of
// at most a factor of two. Walls thinner than a voxel may vanish. If the grids differ by whole blocks, the blocks are
// shared and nothing is interpolated. Runs on all threads of the arena; O(blocks of the result near the surface).
//
// Errors: VolumeErrors::TooFine (if indices would exceed the largest index of a volume), TooLarge (for the memory that
// the system has left); Cancelled.
Result<SparseVolume> resampled(const SparseVolume& volume, const Vec3& origin, double voxel, Progress progress = {});

}  // namespace handwheel
