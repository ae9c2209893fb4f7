// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"
#include "proximity/BoxTree.h"
#include "proximity/TriangleBoxes.h"
#include "proximity/TriangleIntersection.h"

#include <vector>

namespace handwheel {

// A triangle of a contact surface, with its id.
struct ContactTriangle {
  TrianglePoints corners;  // mm
  std::uint32_t id = kNone;
};

// Bounding volume hierarchy over contact triangles. The triangles are stored in the order of its leaves. The hierarchy
// is immutable, and may be read on any thread. It takes about 140 bytes per triangle: the corners are stored next to
// each other, because on the servo thread each cache miss costs a tenth of a microsecond.
class ContactHierarchy {
 public:
  // Triangles with a coordinate that is not finite are omitted. The hierarchy is empty if the construction was
  // cancelled.
  explicit ContactHierarchy(std::vector<ContactTriangle> triangles, Progress progress = {});

  std::size_t size() const { return m_triangles.size(); }
  const ContactTriangle& triangle(std::size_t slot) const { return m_triangles[slot]; }

  const Box& bounds() const { return m_bounds; }

  // Calls visit(slot) for each triangle whose bounding box meets the box (boundaries included) until visit returns
  // false. Returns false if visit did. Neither allocates nor locks.
  template <class Visit>
  bool forEachInBox(const Box& box, Visit visit) const {
    const FloatBox query = m_frame.around(box.min(), box.max(), box.max());
    const std::uint32_t end = m_tree.nodeCount();
    for (std::uint32_t i = 0; i < end;) {
      const BoxNode& node = m_tree.node(i);
      if (!node.box.meets(query)) {
        i += node.size();
        continue;
      }
      if (node.isLeaf()) {
        for (std::uint32_t slot = node.first(); slot < m_tree.leafEnd(i); ++slot)
          if (meets(m_triangles[slot].corners, box) && !visit(slot)) return false;
      }
      ++i;
    }
    return true;
  }

  // Returns true if the bounding box of a triangle meets a box. It uses one branch instead of six, which would often be
  // mispredicted.
  static bool meets(const TrianglePoints& t, const Box& box) {
    const Eigen::Array3d low = t[0].array().min(t[1].array()).min(t[2].array());
    const Eigen::Array3d high = t[0].array().max(t[1].array()).max(t[2].array());
    int all = 1;
    for (int k = 0; k < 3; ++k) all &= int{low[k] <= box.max()[k]} & int{box.min()[k] <= high[k]};
    return all != 0;
  }

 private:
  BoxFrame m_frame;
  BoxTree m_tree;
  std::vector<ContactTriangle> m_triangles;
  Box m_bounds;
};

}  // namespace handwheel
