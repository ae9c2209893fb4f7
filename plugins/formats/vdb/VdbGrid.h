// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "volume/vdb/VdbVolume.h"

#include <openvdb/openvdb.h>

namespace handwheel {

// Returns the volume of the first level set. If there is no level set, the first fog volume is used. Errors:
// LibraryFailed with the reason.
Result<VdbVolume> volumeOfGrids(const openvdb::GridPtrVec& grids);

// Converts a volume to a level set, three voxels deep on both sides.
openvdb::FloatGrid::Ptr gridOf(const SparseVolume& volume);

}  // namespace handwheel
