// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/SnapFeatures.h"
#include "haptics/SnapLayer.h"

namespace handwheel {

// A snapshot of everything that the hand may snap to: built on a worker, read on the servo thread, never changed. The
// snap distance is not part of it and may differ from tick to tick. O(n log n) to build, on all threads of the arena;
// about 130 bytes an item (a curve of n points has 2 n - 3).
class SnapField {
 public:
  static constexpr std::size_t kDimensions = 3;  // points, lines, triangles

  SnapField() = default;
  // Empty once cancelled.
  explicit SnapField(const SnapFeatures& features, Progress progress = {});

  bool empty() const;
  const SnapLayer& layer(std::size_t dimension) const { return m_layers[dimension]; }
  // Items keep their places relative to it, so that distances lose no digits far from the origin.
  const Vec3& origin() const { return m_origin; }

 private:
  Vec3 m_origin = Vec3::Zero();
  std::array<SnapLayer, kDimensions> m_layers;
};

}  // namespace handwheel
