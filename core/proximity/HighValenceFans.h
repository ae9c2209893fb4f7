// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"
#include "proximity/BoxTree.h"

#include <functional>
#include <span>
#include <vector>

namespace handwheel {

// Fans of very many triangles around a vertex, for intersection search. In a fan of n triangles, all boxes meet at the
// vertex, so n² pairs would be tested. Two triangles that share only this corner meet elsewhere if and only if their
// arcs on a sphere around the vertex meet; therefore the boxes of the arcs are used instead.
class HighValenceFans {
 public:
  static constexpr std::uint32_t kCrowd = 64;  // largest number of triangles of an ordinary fan

  HighValenceFans() = default;
  // Finds the fans among the triangles of these items, which must have area. Each triangle is in at most one fan. O(n).
  HighValenceFans(std::span<const Vec3> points, std::span<const Triangle> triangles, std::span<const BoxedItem> items);

  bool empty() const { return m_fanOf.empty(); }
  // Returns the vertex of a triangle's fan; kNone if the triangle is in no fan.
  std::uint32_t of(std::uint32_t triangle) const { return m_fanOf.empty() ? kNone : m_fanOf[triangle]; }

  // Visits all pairs of triangles of the same fan that meet, and some other pairs, until a visit returns false. O(n log
  // n + c) for c pairs visited. Returns false if a visit returned false, or if cancelled.
  bool forEachPair(const std::function<bool(std::uint32_t, std::uint32_t)>& visit, Progress progress) const;

 private:
  std::vector<BoxedItem> arcsOf(std::span<const std::uint32_t> fan) const;

  std::span<const Vec3> m_points;
  std::span<const Triangle> m_triangles;
  std::vector<std::uint32_t> m_fanOf;              // vertex of each triangle's fan, or kNone
  std::vector<std::vector<std::uint32_t>> m_fans;  // triangles of the fans, ascending; fans in order of their vertices
};

}  // namespace handwheel
