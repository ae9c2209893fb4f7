// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/snap/SnapFeatures.h"
#include "haptics/snap/SnapLayer.h"

namespace handwheel {

// Immutable spatial index of all features to snap to. It is built on a worker thread and read on the servo thread. The
// snap distance is not part of the index, and may differ from tick to tick. Building takes O(n log n) on all threads of
// the arena. The index takes about 130 bytes per item (a curve of n points has 2 n - 3 items).
class SnapField {
 public:
  static constexpr std::size_t kDimensions = 3;  // points, lines, triangles

  SnapField() = default;
  // The index is empty if the construction was cancelled.
  explicit SnapField(const SnapFeatures& features, Progress progress = {});

  bool empty() const;
  const SnapLayer& layer(std::size_t dimension) const { return m_layers[dimension]; }
  // Returns the point to which items are relative, so that distances lose no digits far from the coordinate origin.
  const Vec3& origin() const { return m_origin; }

 private:
  Vec3 m_origin = Vec3::Zero();
  std::array<SnapLayer, kDimensions> m_layers;
};

}  // namespace handwheel
