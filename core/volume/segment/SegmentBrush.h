// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/segment/Segment.h"

#include <optional>

namespace handwheel {

// Paints samples into a segment, or erases them from it.
struct SegmentBrush {
  double radius = 5.0;  // mm, above 0
  bool isErasing = false;
  std::optional<int> plane;  // the axis of the image across which it is a disc in one slice; none: a ball
};

// Takes all samples within the radius of the way from one place to another; of a disc those in the slice of the
// second place. Places are indices in the image, and may lie outside of it. O(samples of the box around the way).
void applyBrush(Segment& segment, const ImageVolume& image, const SegmentBrush& brush, const Vec3& from,
                const Vec3& to);

}  // namespace handwheel
