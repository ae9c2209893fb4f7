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
// an integer only for a closed surface (Jacobson et al. 2013). Far groups of triangles are replaced by the first two
// terms of their expansion (Barill et al., "Fast winding numbers for soups and clouds", 2018), with an error of about
// 0.001. Immutable; reading on several threads is safe.
class SolidAngleTree {
 public:
  // O(n log n).
  SolidAngleTree(const TriangleSoup& soup, std::span<const std::uint32_t> triangles);

  double turns(const Vec3& p) const;

 private:
  using Corners = std::array<Vec3, 3>;
  struct Node {
    Vec3 centre, area;       // centre of the triangles; sum of their area vectors
    Eigen::Matrix3d moment;  // sum of (middle - centre) × area vector
    double radius = 0.0;
    std::uint32_t first = 0, end = 0;  // range of triangles
    std::uint32_t right = 0;           // second child, the first follows the node; 0: a leaf
  };
  void build(std::uint32_t first, std::uint32_t end);

  std::vector<Corners> m_triangles;
  std::vector<Node> m_nodes;
};

}  // namespace handwheel
