// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/snap/SnapFeatures.h"
#include "haptics/snap/SnapLayer.h"

namespace handwheel {

// Immutable spatial index of all features to snap to. Built on a worker, read on the servo thread. The snap distance is
// not part of it and may differ from tick to tick. O(n log n) to build, on all threads of the arena; about 130 bytes an
// item (a curve of n points has 2 n - 3).
class SnapField {
 public:
  static constexpr std::size_t kDimensions = 3;  // points, lines, triangles

  SnapField() = default;
  // Empty if cancelled.
  explicit SnapField(const SnapFeatures& features, Progress progress = {});

  bool empty() const;
  const SnapLayer& layer(std::size_t dimension) const { return m_layers[dimension]; }
  // Items are stored relative to this point, so that distances lose no digits far from the coordinate origin.
  const Vec3& origin() const { return m_origin; }

 private:
  Vec3 m_origin = Vec3::Zero();
  std::array<SnapLayer, kDimensions> m_layers;
};

}  // namespace handwheel
