// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "volume/SparseVolume.h"

namespace handwheel {

enum class VolumeBoolean {
  Unite,      // material of at least one volume
  Subtract,   // material of the first volume that is not in the second one
  Intersect,  // material of both volumes
};

// Performs a boolean operation on two volumes, in the grid of the first. The second is resampled if its grid differs
// (resampled()). The sign of each voxel is exact, and depths refer to the nearer of the two surfaces. Blocks that one
// volume alone determines are shared with it. The result may be empty. Runs on all threads of the arena; O(blocks of
// the second volume, or of the first one for an intersection). Errors: the errors of resampled(); Cancelled.
Result<SparseVolume> combined(const SparseVolume& first, const SparseVolume& second, VolumeBoolean how,
                              Progress progress = {});

}  // namespace handwheel
