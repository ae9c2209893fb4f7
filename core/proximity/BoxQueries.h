// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "proximity/BoxTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace handwheel {

// A bound on the relative rounding error of a query's coordinates. It allows for several roundings of 2^-53. The error
// of the triangles' own coordinates is within the margins of their boxes.
inline constexpr double kQueryRounding = 0x1p-48;
// A bound on the relative rounding error of a quotient or a sum of squares that is computed from such coordinates.
inline constexpr double kResultRounding = 1e-15;

// A conservative ray-box intersection test by the slab method. The entry point is never too late (Ize, "Robust BVH ray
// traversal", JCGT 2013; in addition, the origin is widened).
class RaySlabs {
 public:
  RaySlabs(const Vec3& origin, const Vec3& direction) {
    const double margin = kQueryRounding * origin.cwiseAbs().maxCoeff();
    for (Eigen::Index k = 0; k < 3; ++k) {
      const bool backward = std::signbit(direction[k]);
      Slab& slab = m_slabs[static_cast<std::size_t>(k)];
      slab.backward = backward;
      // The value is finite, so that no 0 times infinity arises.
      slab.inverse = std::copysign(std::min(1.0 / std::abs(direction[k]), 1e300), direction[k]);
      slab.near = origin[k] + (backward ? -margin : margin);
      slab.far = origin[k] - (backward ? -margin : margin);
    }
  }

  // Returns the entry point as a multiple of the direction's length; infinite if the ray misses.
  double enter(const FloatBox& box) const {
    double in = 0.0;
    double out = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 0; k < 3; ++k) {
      const Slab& slab = m_slabs[static_cast<std::size_t>(k)];
      const double low = box.low[k], high = box.high[k];
      in = std::max(in, ((slab.backward ? high : low) - slab.near) * slab.inverse);
      out = std::min(out, ((slab.backward ? low : high) - slab.far) * slab.inverse);
    }
    const bool hit = in <= out * (1.0 + kResultRounding);
    return hit ? in * (1.0 - kResultRounding) : std::numeric_limits<double>::infinity();
  }

 private:
  struct Slab {
    double inverse, near, far;
    bool backward;
  };
  std::array<Slab, 3> m_slabs;
};

// A lower bound of the squared distance from a point to a box. It never exceeds the squared distance to the contents of
// the box.
class PointToBox {
 public:
  explicit PointToBox(const Vec3& p) {
    const double margin = kQueryRounding * p.cwiseAbs().maxCoeff();
    m_low = p.array() - margin;
    m_high = p.array() + margin;
  }

  double squaredDistance(const FloatBox& box) const {
    double sum = 0.0;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double low = box.low[k], high = box.high[k];
      const double d = std::max({0.0, low - m_high[k], m_low[k] - high});
      sum += d * d;
    }
    return sum * (1.0 - kResultRounding);
  }

 private:
  Vec3 m_low, m_high;
};

// Traverses a box tree depth-first, the better child first, and prunes by bounds. Calls leaf(begin, end) with the range
// of items of each leaf that is not pruned. bound(box) must return the least value that an item in the box can have, or
// infinity if no item can have one. Boxes whose bound exceeds limit() are skipped; limit() may decrease during the
// traversal.
template <class Bound, class Limit, class Leaf>
void visitBestFirst(const BoxTree& tree, Bound bound, Limit limit, Leaf leaf) {
  struct Visit {
    std::uint32_t node;
    double bound;
  };
  std::array<Visit, BoxTree::kMaxDepth + 1> stack;  // each level leaves at most one node on the stack
  std::size_t size = 0;
  const auto push = [&](const Visit& v) {
    if (v.bound <= limit() && v.bound < std::numeric_limits<double>::infinity()) stack[size++] = v;
  };
  const auto visitOf = [&](std::uint32_t node) { return Visit{node, bound(tree.node(node).box)}; };
  if (!tree.empty()) push(visitOf(0));
  while (size > 0) {
    const Visit visit = stack[--size];
    if (visit.bound > limit()) continue;
    const BoxNode& node = tree.node(visit.node);
    if (node.isLeaf()) {
      leaf(node.first(), tree.leafEnd(visit.node));
      continue;
    }
    const std::uint32_t left = visit.node + 1;
    Visit nearer = visitOf(left);
    Visit farther = visitOf(left + tree.node(left).size());
    if (farther.bound < nearer.bound) std::swap(nearer, farther);
    push(farther);
    push(nearer);
  }
}

}  // namespace handwheel
