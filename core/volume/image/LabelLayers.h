// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageFile.h"

#include <optional>

namespace handwheel {

// A segment in a file of several layers. Its samples are those of its layer with its value.
struct LayerSegment {
  double value = 1.0;
  std::size_t layer = 0;
  std::string name = {};
};

// Makes a label map of the samples of several layers, which may overlap. all: the samples, with those of a position
// beside each other if isInterleaved is true, or else layer by layer; its grid must have `layers` times the samples of
// `grid`. Segments keep their values if these differ, and are numbered from 1 otherwise; so are values without a
// segment. A sample of several segments gets the last of them, with a remark. Returns nothing if there are more than
// kMostLabels values, which are no labels.
std::optional<ImageFile> imageOfLayers(const ImageGrid& grid, const ImageVolume& all, std::size_t layers,
                                       bool isInterleaved, std::vector<LayerSegment> segments);

}  // namespace handwheel
