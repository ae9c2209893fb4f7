// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageVolume.h"

namespace handwheel {

// The histogram of an image. Its bins are of equal width, from the least value to the largest.
struct ImageHistogram {
  ValueRange values{0.0, 0.0};      // range of the image
  std::vector<std::size_t> counts;  // a bin includes its lower end; the last bin includes both ends

  double width() const { return (values.largest - values.least) / static_cast<double>(counts.size()); }
  std::size_t binOf(double value) const;
  // Returns the value below which this fraction (0 to 1) of the samples lies, to the width of a bin.
  double quantile(double share) const;
};

inline constexpr std::size_t kHistogramBins = 4096;

// Returns the histogram of an image. bins: at least 1. Runs on all threads of the arena; O(samples).
ImageHistogram histogramOf(const ImageVolume& image, std::size_t bins = kHistogramBins);

// Returns the threshold with the largest variance between the two classes, to the width of a bin (Otsu 1979, "A
// threshold selection method from gray-level histograms").
double otsuThreshold(const ImageHistogram& histogram);

// Returns the range with an end made infinite if no value lies beyond it. Such an end excludes no samples, and, being
// infinite, does not affect depths.
ValueRange withoutIdleEnds(const ValueRange& range, const ValueRange& values);

// Returns true if the values look like those of a CT in Hounsfield units: they include air, at about -1000, and
// material as dense as bone. Only DICOM files state the unit.
bool looksLikeHounsfield(const ValueRange& values);

}  // namespace handwheel
