// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Operation.h"
#include "volume/SparseVolume.h"
#include "volume/image/ImageVolume.h"

#include <functional>
#include <optional>
#include <string_view>

namespace handwheel {

// The operation that makes a volume of an image. Its values are the range, the number of largest parts to keep, the
// voxel, and a flag for smoothing.
const Operation& segmentOperation();

// Parses a range such as "300:2000", or one that is open at an end: "300:" or ":50". Returns nothing for any other
// text.
std::optional<ValueRange> rangeIn(std::string_view text);

struct Segmented {
  SparseVolume volume;
  ValueRange range;       // range that was used
  std::size_t parts = 0;  // number of connected parts before the smaller ones were removed
  std::size_t kept = 0;
};

// A function that is called before a volume is made. voxel: edge of a voxel, mm. bytes: memory that the volume needs.
// An error that it returns ends the work.
using BeginMaking = std::function<Status(double voxel, double bytes)>;
// Makes a volume of an image. An empty range means all values above otsuThreshold(), or all
// labels. Errors: those of volumeOfImage()
// and of `begin`; VolumeErrors::NothingInRange also if smoothing leaves nothing.
Result<Segmented> segment(const ImageVolume& image, const OperationValues& values, Progress progress,
                          const BeginMaking& begin = {});

}  // namespace handwheel
