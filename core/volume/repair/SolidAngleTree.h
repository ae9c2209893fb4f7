// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace handwheel {

// A tree of triangles that evaluates their generalised winding number. That is the sum of their solid angles in turns,
// whole only for a closed surface (Jacobson et al. 2013). Far from a group of triangles it is that of the first two
// terms of their expansion (Barill et al., "Fast winding numbers for soups and clouds", 2018): within about 0.001. A
// value that any thread may read.
class SolidAngleTree {
 public:
  // O(n log n).
  SolidAngleTree(const TriangleSoup& soup, std::span<const std::uint32_t> triangles);

  double turns(const Vec3& p) const;

 private:
  using Corners = std::array<Vec3, 3>;
  struct Node {
    Vec3 centre, area;       // the middle of the triangles; the sum of their area vectors
    Eigen::Matrix3d moment;  // the sum of (middle - centre) × area vector
    double radius = 0.0;
    std::uint32_t first = 0, end = 0;  // triangles
    std::uint32_t right = 0;           // the second of two halves, the first follows; 0: a leaf
  };
  void build(std::uint32_t first, std::uint32_t end);

  std::vector<Corners> m_triangles;
  std::vector<Node> m_nodes;
};

}  // namespace handwheel
