// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "dicom/DicomSlice.h"

namespace handwheel {

// The slices of one image, sorted by height, with remarks on them.
struct Series {
  std::vector<DicomSlice> slices;
  Vec3 step = Vec3::UnitZ();    // from slice to slice of the image that they make, mm
  std::vector<double> heights;  // of each above the first, in steps
  std::size_t count = 0;        // slices of that image
  double tilt = 0.0;            // degrees between the step and the normal; 0: none
  bool isUneven = false;
  double least = 0.0, largest = 0.0;  // mm between slices
  std::size_t missing = 0;            // where the distances are multiples of one
  std::size_t others = 0;             // slices of other series
  std::size_t samePlace = 0;          // slices that were left out
};

// Puts the slices in order: of the largest series, or that of the first slice. What is uneven gets even steps of the
// usual distance, for slices to be made between. Errors: LibraryFailed with the reason.
Result<Series> seriesOf(std::vector<DicomSlice> slices, bool ofFirst);

}  // namespace handwheel
