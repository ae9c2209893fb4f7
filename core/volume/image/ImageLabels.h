// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageVolume.h"

namespace handwheel {

// Largest number of labels in an image.
inline constexpr std::size_t kMostLabels = 4096;

// Returns true if the values look like labels of regions. They are few integers, the least of them 0, which change
// without steps between: by rows, at least twice as many changes are sudden as have a value between. O(samples).
bool looksLikeLabels(const ImageVolume& image);

// Makes a label map of an image whose values are integers: its labels are its values other than 0. Names of other
// values are dropped, and invalid characters in names are replaced. The image stays as it is if it has too many values,
// or values that are not integers. O(samples).
void markLabels(ImageVolume& image, const std::vector<ImageLabel>& names);

// The size of a region.
struct LabelRegion {
  ImageLabel label;
  std::size_t samples = 0;
  double volume = 0.0;  // volume of its samples, mm³
};
// Returns the regions of a label map, in the order of its labels. O(samples).
std::vector<LabelRegion> regionsOf(const ImageVolume& image);

// Returns the range of all labels of a label map: all values but 0, unless some are negative.
ValueRange rangeOfLabels(const ImageVolume& image);

}  // namespace handwheel
