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

// The operation that makes a volume of an image. Its values are the range, how many of the largest parts, the voxel,
// whether it is smoothed.
const Operation& segmentOperation();

// A range as it is typed: "300:2000", or open at an end, "300:" or ":50". None for anything else.
std::optional<ValueRange> rangeIn(std::string_view text);

struct Segmented {
  SparseVolume volume;
  ValueRange range;       // that was taken
  std::size_t parts = 0;  // that hang together, before the smaller ones were taken away
  std::size_t kept = 0;
};

// The range must be one, or empty: then it is what is above the threshold that parts the image best (otsuThreshold()).
// begin: called before the volume is made, with its voxel, mm, and the bytes that it needs; its error ends the work.
// Errors: those of volumeOfImage(); VolumeErrors::NothingInRange also where smoothing leaves nothing.
using BeginMaking = std::function<Status(double voxel, double bytes)>;
Result<Segmented> segment(const ImageVolume& image, const OperationValues& values, Progress progress,
                          const BeginMaking& begin = {});

}  // namespace handwheel
