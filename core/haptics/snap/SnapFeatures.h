// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/snap/SnapItem.h"

#include <span>
#include <vector>

namespace handwheel {

// Collects the features to snap to, for building a SnapField. It must not be used on the servo thread. A feature with a
// coordinate that is not finite, or beyond 1e100 mm, is left out. Segments without length and triangles without area
// are kept; they act as points or segments. The caller chooses the ids, and the field returns them.
class SnapFeatures {
 public:
  void addPoint(std::uint32_t id, const Vec3& p);
  void addSegment(std::uint32_t id, const Vec3& a, const Vec3& b);
  void addTriangle(std::uint32_t id, const Vec3& a, const Vec3& b, const Vec3& c);
  // Adds a polyline as one feature; a closed one returns to its first point. Points equal to the previous one are
  // skipped; a curve with one point left becomes a point.
  void addCurve(std::uint32_t id, std::span<const Vec3> points, bool isClosed);

  std::span<const SnapItem> items() const { return m_items; }
  std::size_t leftOut() const { return m_leftOut; }

 private:
  void add(const SnapItem& item);

  std::vector<SnapItem> m_items;
  std::size_t m_leftOut = 0;
};

}  // namespace handwheel
