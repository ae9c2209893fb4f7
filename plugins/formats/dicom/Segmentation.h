// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "dicom/DicomSlice.h"
#include "volume/image/ImageFile.h"

namespace handwheel {

// A label map made of the frames of a segmentation.
struct SegmentationImage {
  ImageFile file;                // labels are the segments with their names
  std::size_t samePosition = 0;  // number of frames that were omitted because another one has the same position
  std::size_t overlaps = 0;      // number of samples that belong to several segments
};

// Makes a label map of the frames of one segmentation (PS3.3, A.51). Each frame has one segment at one position, or all
// of them. Positions without a frame are empty: nothing is interpolated. A sample of several segments gets the one with
// the largest number. Fractions belong to a segment from one half on. Errors: LibraryFailed with the reason.
Result<SegmentationImage> imageOfSegmentation(const std::vector<DicomSlice>& frames, Progress progress);

}  // namespace handwheel
