// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

namespace handwheel {

// A volume in voxels twice as large, to be looked at. The origin stays, and each sample is the deepest of the 27 around
// it. So no wall is torn, however thin: what keeps two voids apart keeps them apart still. Surfaces go outwards by up
// to one voxel of the volume along each axis, and what is narrower than two closes. The depths are distances. On all
// threads of the arena; O(blocks).
SparseVolume downsampledVolume(const SparseVolume& volume);

}  // namespace handwheel
