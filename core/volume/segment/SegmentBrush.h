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
  // Axis of the image perpendicular to the slice in which the brush is a disc. Without an axis the brush is a ball.
  std::optional<int> plane;
};

// Paints or erases all samples within the radius of the line segment between two positions. A disc changes only the
// samples in the slice of the second position. Positions are indices in the image, and may lie outside it. O(samples of
// the bounding box).
void applyBrush(Segment& segment, const ImageVolume& image, const SegmentBrush& brush, const Vec3& from,
                const Vec3& to);

}  // namespace handwheel
