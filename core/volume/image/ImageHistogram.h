// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageVolume.h"

namespace handwheel {

// The histogram of an image. Its bins are of one width from the least value to the largest.
struct ImageHistogram {
  ValueRange values{0.0, 0.0};      // of the image
  std::vector<std::size_t> counts;  // a bin holds its lower end; the last one both

  double width() const { return (values.largest - values.least) / static_cast<double>(counts.size()); }
  std::size_t binOf(double value) const;
  // The value below which this share of the samples lies, to a bin. share: 0 to 1.
  double quantile(double share) const;
};

inline constexpr std::size_t kHistogramBins = 4096;

// bins: at least 1. On all threads of the arena; O(samples).
ImageHistogram histogramOf(const ImageVolume& image, std::size_t bins = kHistogramBins);

// The value that parts a histogram best in two: the variance between what is below and what is not is the largest (Otsu
// 1979, "A threshold selection method from gray-level histograms"), to a bin.
double otsuThreshold(const ImageHistogram& histogram);

// The same range without the ends that no value passes: what is erased is then as far outside as the other end says.
ValueRange withoutIdleEnds(const ValueRange& range, const ValueRange& values);

// Whether the values look like those of a CT in Hounsfield units: air, at about -1000, and something as dense as bone.
// Files do not say it, but for DICOM.
bool looksLikeHounsfield(const ValueRange& values);

}  // namespace handwheel
