// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "volume/vdb/VdbVolume.h"

#include <openvdb/openvdb.h>

namespace handwheel {

// Returns the volume of the first level set, or else of the first fog volume. Errors: LibraryFailed with the reason.
Result<VdbVolume> volumeOfGrids(const openvdb::GridPtrVec& grids);

// Returns a level set of a volume, three voxels deep on both sides.
openvdb::FloatGrid::Ptr gridOf(const SparseVolume& volume);

}  // namespace handwheel
