// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace handwheel {

// A closed planar polygon, divided into rows for fast point-in-polygon tests. It may intersect itself.
class PointInPolygonTester {
 public:
  using Vec2 = Eigen::Vector2d;

  // The coordinates must be finite.
  explicit PointInPolygonTester(std::span<const Vec2> corners);

  // Returns true if the polygon contains p by the even-odd rule. A point on an edge is inside if the polygon is to its
  // right or above it. O(edges of a row).
  bool contains(const Vec2& p) const;

 private:
  struct Edge {
    Vec2 low, high;  // ends with the lower and the higher y
  };
  std::size_t row(double y) const;

  double m_low = 0.0;
  double m_high = 0.0;
  double m_rowsPerUnit = 0.0;
  std::vector<Edge> m_edges;           // row by row; an edge is listed in each row that it passes
  std::vector<std::uint32_t> m_first;  // first edge per row, with an end entry
};

}  // namespace handwheel
