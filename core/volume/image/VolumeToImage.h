// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "volume/SparseVolume.h"
#include "volume/image/ImageVolume.h"

namespace handwheel {

// What an image of VolumeToImage holds, as the field "content" of NRRD says it.
inline constexpr const char* kSignedDistance = "signed distance in mm, inside below 0";

// The distances of a volume from its surface as an image of all its voxels, mm: below 0 inside, limited to nearly four
// voxels. Errors: VolumeErrors::TooLarge (for a third of the memory that is left), those of checkGrid().
Result<ImageVolume> distancesOf(const SparseVolume& volume);

}  // namespace handwheel
