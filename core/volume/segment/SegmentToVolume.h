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
// Painted and erased samples get a value reflected at an end of the range, so that the surface there is about midway
// between samples; this needs four bytes for each sample temporarily. voxel: see volumeOfImage(). Errors: those of
// volumeOfImage(), OutOfMemory.
Result<SparseVolume> volumeOfSegment(const ImageVolume& image, const Segment& segment, std::optional<double> voxel,
                                     Progress progress = {});

// Makes a volume of a segment, and smooths the steps of voxels (VolumeFilters.h) if isSmoothed. Errors:
// VolumeErrors::NothingInRange also if smoothing leaves nothing.
Result<SparseVolume> volumeOfSmoothed(const ImageVolume& image, const Segment& segment, std::optional<double> voxel,
                                      bool isSmoothed, Progress progress = {});

// Returns the area of the faces between samples inside and outside a segment, including the border of the image; mm².
// O(samples); on all threads of the arena.
double facesOf(const ImageVolume& image, const Segment& segment, const Progress& progress = {});

// Predicts the memory of a segment's volume with its surface from the area of its faces, to about a half; bytes.
double predictedBytes(const ImageVolume& image, const Segment& segment, double faces, double voxel);

}  // namespace handwheel
