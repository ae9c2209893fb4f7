// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace handwheel {

// A tree of triangles that evaluates their generalised winding number. The generalised winding number is the sum of the
// solid angles of the triangles in turns; it is an integer only for closed surfaces (Jacobson et al. 2013). Far groups
// of triangles are replaced by the first two terms of their expansion (Barill et al., "Fast winding numbers for soups
// and clouds", 2018), with an error of about 0.001. Trees are immutable, and may be read on several threads.
class SolidAngleTree {
 public:
  // Builds the tree of these triangles of a soup. O(n log n).
  SolidAngleTree(const TriangleSoup& soup, std::span<const std::uint32_t> triangles);

  double turns(const Vec3& p) const;

 private:
  using Corners = std::array<Vec3, 3>;
  struct Node {
    Vec3 centre, area;       // centre of the triangles, and sum of their area vectors
    Eigen::Matrix3d moment;  // sum of (middle - centre) × area vector
    double radius = 0.0;
    std::uint32_t first = 0, end = 0;  // range of triangles
    std::uint32_t right = 0;           // index of the second child (the first child follows its parent); 0: a leaf
  };
  void build(std::uint32_t first, std::uint32_t end);

  std::vector<Corners> m_triangles;
  std::vector<Node> m_nodes;
};

}  // namespace handwheel
