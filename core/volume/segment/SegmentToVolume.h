// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "volume/SparseVolume.h"
#include "volume/segment/Segment.h"

#include <optional>

namespace handwheel {

// Makes a volume of a segment. Where the segment is defined by the range, the surface is that of volumeOfImage().
// The value of a painted or erased sample is mirrored at the nearest end of the range, to about the same distance on
// its other side, so that the surface there is about midway between samples. This temporarily needs four bytes per
// sample. voxel: see volumeOfImage(). Errors: the errors of volumeOfImage(), and OutOfMemory.
Result<SparseVolume> volumeOfSegment(const ImageVolume& image, const Segment& segment, std::optional<double> voxel,
                                     Progress progress = {});

// Makes a volume of a segment, and smooths the steps of voxels (VolumeFilters.h) if isSmoothed is true. Errors: the
// errors of volumeOfSegment(); VolumeErrors::NothingInRange also if smoothing leaves nothing.
Result<SparseVolume> volumeOfSmoothed(const ImageVolume& image, const Segment& segment, std::optional<double> voxel,
                                      bool isSmoothed, Progress progress = {});

// Returns the area of the faces between samples inside and outside a segment, including the border of the image, mm².
// Runs on all threads of the arena. O(samples).
double facesOf(const ImageVolume& image, const Segment& segment, const Progress& progress = {});

// Predicts the memory of a segment's volume with its surface from the area of its faces, bytes. The prediction may be
// wrong by about one half.
double predictedBytes(const ImageVolume& image, const Segment& segment, double faces, double voxel);

}  // namespace handwheel
