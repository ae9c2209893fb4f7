// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "volume/SparseVolume.h"
#include "volume/segment/Segment.h"

#include <optional>

namespace handwheel {

// Makes a volume of a segment. Where the range says what is in it the surface is that of volumeOfImage(), between the
// samples. What is painted or erased counts as if its value were on the other side of the range, as far from its end:
// so the surface there is about half way between samples. Then four bytes are taken for each sample meanwhile.
// voxel: as there. Errors: those of volumeOfImage(), OutOfMemory.
Result<SparseVolume> volumeOfSegment(const ImageVolume& image, const Segment& segment, std::optional<double> voxel,
                                     Progress progress = {});

// The same with the steps of voxels taken off (VolumeFilters.h), where that is wanted. Errors:
// VolumeErrors::NothingInRange also where that leaves nothing.
Result<SparseVolume> volumeOfSmoothed(const ImageVolume& image, const Segment& segment, std::optional<double> voxel,
                                      bool isSmoothed, Progress progress = {});

// The area of the faces between samples in a segment and those that are not, the border of the image included; mm².
// O(samples); on all threads of the arena.
double facesOf(const ImageVolume& image, const Segment& segment, const Progress& progress = {});

// The memory that the volume of a segment with its surface takes, to about a half, by its faces; bytes.
double predictedBytes(const ImageVolume& image, const Segment& segment, double faces, double voxel);

}  // namespace handwheel
