// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "volume/SparseVolume.h"
#include "volume/image/ImageVolume.h"

#include <optional>

namespace handwheel {

// Makes a volume of the samples of an image with values in this range. Values are interpolated linearly; between the
// samples of a label map, the surface is half way. Along each row
// of voxels, the surface is where they pass an end of the range; the depths around the surface are computed from these
// positions (VolumeFilters.h). Material at the border of the image is closed half a step beyond the outermost samples.
//
// voxel: edge length of a voxel, mm; none: usualVoxel(). Voxels are aligned with the axes of the world, even if those
// of the image are not; if they are, and the voxel equals the spacing, each voxel is a sample. Runs on all threads of
// the arena; O(samples + voxels / 512 + voxels near the surface). Errors: ValueOutOfRange (for the voxel),
// VolumeErrors::TooFine, TooLarge (for the memory that the system has left), NothingInRange; Cancelled.
Result<SparseVolume> volumeOfImage(const ImageVolume& image, const ValueRange& range, std::optional<double> voxel,
                                   Progress progress = {});

// Returns the error for an image without samples in this range.
Error nothingInRange(const ValueRange& range, const ImageVolume& image);

// Returns the least spacing of the samples, mm.
double usualVoxel(const ImageGrid& grid);

}  // namespace handwheel
