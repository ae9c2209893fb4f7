// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "volume/SparseVolume.h"
#include "volume/image/ImageVolume.h"

namespace handwheel {

// Content of an image made by distancesOf(), for the field "content" of NRRD.
inline constexpr const char* kSignedDistance = "signed distance in mm, inside below 0";

// Returns the distances of a volume from its surface as an image of all its voxels, mm: negative inside, limited to
// nearly four voxels. Errors: VolumeErrors::TooLarge (for more than a third of the free memory), those of checkGrid().
Result<ImageVolume> distancesOf(const SparseVolume& volume);

}  // namespace handwheel
