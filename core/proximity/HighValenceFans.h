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

// Fans of very many triangles around a vertex, for intersection search. In a fan of n their boxes all meet at the
// vertex, so n² pairs would have to be tested. Triangles that share no more than this corner meet elsewhere exactly
// when the arcs meet that they cut out of a sphere around it; the arcs are boxed instead.
class HighValenceFans {
 public:
  static constexpr std::uint32_t kCrowd = 64;  // the most triangles of an ordinary fan

  HighValenceFans() = default;
  // Finds the fans of the triangles of these items, which have area. Each is in one fan at most. O(n).
  HighValenceFans(std::span<const Vec3> points, std::span<const Triangle> triangles, std::span<const BoxedItem> items);

  bool empty() const { return m_fanOf.empty(); }
  // The vertex of a triangle's fan; kNone when it is in none.
  std::uint32_t of(std::uint32_t triangle) const { return m_fanOf.empty() ? kNone : m_fanOf[triangle]; }

  // Visits pairs of triangles of one fan until the visit returns false: all that meet, and some more. O(n log n + c)
  // for c pairs visited. False when a visit returned false, or when cancelled.
  bool forEachPair(const std::function<bool(std::uint32_t, std::uint32_t)>& visit, Progress progress) const;

 private:
  std::vector<BoxedItem> arcsOf(std::span<const std::uint32_t> fan) const;

  std::span<const Vec3> m_points;
  std::span<const Triangle> m_triangles;
  std::vector<std::uint32_t> m_fanOf;              // by triangle
  std::vector<std::vector<std::uint32_t>> m_fans;  // in order of their vertices; rising
};

}  // namespace handwheel
