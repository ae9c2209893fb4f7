// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "volume/SparseVolume.h"
#include "volume/image/ImageVolume.h"

namespace handwheel {

// The content of an image made by distancesOf(), for the field "content" of NRRD.
inline constexpr const char* kSignedDistance = "signed distance in mm, inside below 0";

// Returns an image of the distances from a volume's surface at all its voxels, mm. They are negative inside, and
// limited to nearly four voxels. Errors: VolumeErrors::TooLarge (if the image takes more than a third of the free
// memory), and the errors of checkGrid().
Result<ImageVolume> distancesOf(const SparseVolume& volume);

}  // namespace handwheel
