// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "proximity/TriangleHierarchy.h"
#include "proximity/TriangleIntersection.h"

#include <vector>

namespace handwheel {

inline Box boxOf(const TrianglePoints& t) {
  Box box(t[0]);
  box.extend(t[1]).extend(t[2]);
  return box;
}

// A bounding volume hierarchy to which triangles are added one by one. It consists of hierarchies of doubling size and
// a short list of the newest triangles (Bentley and Saxe, "Decomposable searching problems I", 1980): n additions cost
// O(n log² n) together, and a query costs O(log² n) on ordinary surfaces.
class IncrementalHierarchy {
 public:
  void add(const TrianglePoints& t);

  // Calls visit(corners) for each triangle whose box meets the box (boundaries included) until it returns false.
  // Returns false if a visit returned false.
  template <class Visit>
  bool forEachInBox(const Box& box, Visit visit) const {
    for (const TriangleHierarchy& level : m_levels) {
      if (!level.forEachInBox(box, [&](std::uint32_t i) { return visit(level.corners(i)); })) return false;
    }
    for (const TrianglePoints& t : m_newest) {
      if (boxOf(t).intersects(box) && !visit(t)) return false;
    }
    return true;
  }

 private:
  static constexpr std::uint32_t kListLength = 64;

  std::vector<TriangleHierarchy> m_levels;  // level i is empty or holds kListLength · 2^i triangles
  std::vector<TrianglePoints> m_newest;     // fewer than kListLength triangles
};

}  // namespace handwheel
