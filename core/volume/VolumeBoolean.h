// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "volume/SparseVolume.h"

namespace handwheel {

enum class VolumeBoolean {
  Unite,      // what is in either
  Subtract,   // what is in the first and not in the second
  Intersect,  // what is in both
};

// A boolean operation on two volumes, in the grid of the first. The second is resampled where its grid is another
// (resampled()). Sides of voxels are exact, and depths are those to the nearest surface of the two. Blocks where one
// alone decides are shared with it. May be empty. On all threads of the arena; O(blocks that the second has, or the
// first of an intersection). Errors: those of resampled(); Cancelled.
Result<SparseVolume> combined(const SparseVolume& first, const SparseVolume& second, VolumeBoolean how,
                              Progress progress = {});

}  // namespace handwheel
