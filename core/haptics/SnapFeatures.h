// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/SnapItem.h"

#include <span>
#include <vector>

namespace handwheel {

// What the hand may snap to, as it is gathered for a SnapField: off the servo thread. A feature with a coordinate that
// is not finite, or beyond 1e100 mm, is left out. Segments without length and triangles without area stay: they act as
// the points or segments that they are. The numbers are the caller's; the field gives them back.
class SnapFeatures {
 public:
  void addPoint(std::uint32_t id, const Vec3& p);
  void addSegment(std::uint32_t id, const Vec3& a, const Vec3& b);
  void addTriangle(std::uint32_t id, const Vec3& a, const Vec3& b, const Vec3& c);
  // One feature of consecutive segments; a closed one returns to its first point. Points that repeat the one before are
  // passed over; what is left with one point is a point.
  void addCurve(std::uint32_t id, std::span<const Vec3> points, bool isClosed);

  std::span<const SnapItem> items() const { return m_items; }
  std::size_t leftOut() const { return m_leftOut; }

 private:
  void add(const SnapItem& item);

  std::vector<SnapItem> m_items;
  std::size_t m_leftOut = 0;
};

}  // namespace handwheel
