// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "dicom/DicomSlice.h"

namespace handwheel {

// The slices of one image, sorted by height, with remarks on them.
struct Series {
  std::vector<DicomSlice> slices;
  Vec3 step = Vec3::UnitZ();    // step between slices of the resulting image, mm
  std::vector<double> heights;  // height of each slice above the first, in steps
  std::size_t count = 0;        // number of slices of the resulting image
  double tilt = 0.0;            // degrees between the step and the normal; 0: none
  bool isUneven = false;
  double least = 0.0, largest = 0.0;  // mm between slices
  std::size_t missing = 0;            // number of missing slices, where the distances are multiples of one
  std::size_t others = 0;             // number of slices of other series
  std::size_t samePosition = 0;       // number of slices that were left out, at the position of another one
};

// Sorts the slices of the largest series, or of that of the first slice. Uneven slices get even steps of the
// median distance, to be interpolated. Errors: LibraryFailed with the reason.
Result<Series> seriesOf(std::vector<DicomSlice> slices, bool ofFirst);

}  // namespace handwheel
