// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "volume/SparseVolume.h"

namespace handwheel {

enum class VolumeBoolean {
  Unite,      // material of either
  Subtract,   // material of the first that is not in the second
  Intersect,  // material of both
};

// Performs a boolean operation on two volumes, in the grid of the first. The second is resampled if its grid differs
// (resampled()). The sign of each voxel is exact, and depths refer to the nearer of the two surfaces. Blocks that one
// volume alone determines are shared with it. The result may be empty. On all threads of the arena; O(blocks of the
// second, or of the first for an intersection). Errors: those of resampled(); Cancelled.
Result<SparseVolume> combined(const SparseVolume& first, const SparseVolume& second, VolumeBoolean how,
                              Progress progress = {});

}  // namespace handwheel
