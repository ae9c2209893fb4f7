// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageVolume.h"

namespace handwheel {

// The histogram of an image. Its bins are of equal width, from the least value to the largest.
struct ImageHistogram {
  ValueRange values{0.0, 0.0};      // range of the image
  std::vector<std::size_t> counts;  // a bin includes its lower end; the last one both ends

  double width() const { return (values.largest - values.least) / static_cast<double>(counts.size()); }
  std::size_t binOf(double value) const;
  // Returns the value below which this share (0 to 1) of the samples lies, to the width of a bin.
  double quantile(double share) const;
};

inline constexpr std::size_t kHistogramBins = 4096;

// bins: at least 1. On all threads of the arena; O(samples).
ImageHistogram histogramOf(const ImageVolume& image, std::size_t bins = kHistogramBins);

// Returns the threshold with the largest variance between the two classes, to the width of a bin (Otsu 1979, "A
// threshold selection method from gray-level histograms").
double otsuThreshold(const ImageHistogram& histogram);

// Returns a range with infinite ends where no value lies beyond an end, so that erased samples are measured from the
// other end.
ValueRange withoutIdleEnds(const ValueRange& range, const ValueRange& values);

// Returns true if the values look like those of a CT in Hounsfield units: air, at about -1000, and material as dense as
// bone. Only DICOM files state the unit.
bool looksLikeHounsfield(const ValueRange& values);

}  // namespace handwheel
