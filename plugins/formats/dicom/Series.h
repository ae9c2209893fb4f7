// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "dicom/DicomSlice.h"

namespace handwheel {

// The slices of one image, sorted by height, with remarks for the user.
struct Series {
  std::vector<DicomSlice> slices;
  // Vector from one slice of the resulting image to the next, mm. It goes along the normal of the slices, never against
  // it, so that the axes of the image are always right-handed.
  Vec3 step = Vec3::UnitZ();
  std::vector<double> heights;        // height of each slice above the first, in steps
  std::size_t count = 0;              // number of slices of the resulting image
  double tilt = 0.0;                  // angle between the step and the normal, degrees; 0: no tilt
  bool isUneven = false;              // true: distances between slices are not multiples of one distance
  double least = 0.0, largest = 0.0;  // smallest and largest distance between slices, mm
  std::size_t missing = 0;            // number of missing slices, if all distances are multiples of one distance
  std::size_t samePosition = 0;       // number of slices that were omitted because another slice has the same position
  double assumed = 0.0;               // distance of slices without positions, mm; 0: all have positions
};

// Returns the slices of the largest series, of a segmentation only if there is no image; or if ofFirst is true those of
// the series of the first slice. There must be a slice.
std::vector<DicomSlice> chosenSeries(const std::vector<DicomSlice>& slices, bool ofFirst);

// Sorts the slices of one series. Uneven slices get even steps of the smallest distance, and are to be interpolated.
// Slices without positions get the stated distance. Errors: LibraryFailed with the reason.
Result<Series> seriesOf(std::vector<DicomSlice> own);

}  // namespace handwheel
