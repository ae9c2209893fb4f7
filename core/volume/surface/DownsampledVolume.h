// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

namespace handwheel {

// Returns a volume with voxels twice as large, for display. The origin stays, and each sample is the deepest of the 27
// samples around it, so that thin walls still separate voids. Surfaces move outwards by up to one voxel of the original
// along each axis, and gaps narrower than two voxels close. The depths of the result are distances. Runs on all threads
// of the arena. O(blocks).
SparseVolume downsampledVolume(const SparseVolume& volume);

}  // namespace handwheel
