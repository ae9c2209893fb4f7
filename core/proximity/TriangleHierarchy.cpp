// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proximity/TriangleHierarchy.h"

#include "proximity/ClosestPoint.h"
#include "proximity/RayTriangle.h"

#include <cmath>
#include <limits>

namespace handwheel {
namespace {

// What the rounding of a query in the frame may shift, as a share of its coordinates there: a handful of roundings of
// 2^-53. What concerns the triangle's own coordinates lies within the margin of its box.
constexpr double kQueryRounding = 0x1p-48;

struct Visit {
  std::uint32_t node;
  double bound;  // of what is below: the least distance, or the least squared distance
};

// Nodes yet to be visited. Each level leaves at most one behind.
class VisitStack {
 public:
  bool empty() const { return m_size == 0; }
  void push(Visit v) { m_visits[m_size++] = v; }
  Visit pop() { return m_visits[--m_size]; }
  // So that the nearer one comes first.
  void pushBoth(Visit a, Visit b, double limit) {
    if (b.bound < a.bound) std::swap(a, b);
    if (b.bound <= limit) push(b);
    if (a.bound <= limit) push(a);
  }

 private:
  std::array<Visit, BoxTree::kMaxDepth + 2> m_visits;
  std::size_t m_size = 0;
};

std::uint32_t rightChild(const BoxTree& tree, std::uint32_t node) { return node + 1 + tree.node(node + 1).size(); }

// Where a ray enters a box, never too late (Ize, "Robust BVH ray traversal", JCGT 2013; here the origin is widened too).
class RaySlabs {
 public:
  RaySlabs(const Vec3& origin, const Vec3& direction) {
    const double margin = kQueryRounding * origin.cwiseAbs().maxCoeff();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      m_backward[k] = std::signbit(direction[i]);
      // Finite, so that no 0 times infinity arises.
      m_inverse[k] = std::copysign(std::min(1.0 / std::abs(direction[i]), 1e300), direction[i]);
      const double shift = m_backward[k] ? -margin : margin;
      m_near[k] = origin[i] + shift;
      m_far[k] = origin[i] - shift;
    }
  }

  // Infinite when the ray misses.
  double enter(const FloatBox& box) const {
    double in = 0.0;
    double out = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      const double low = box.low[i];
      const double high = box.high[i];
      in = std::max(in, ((m_backward[k] ? high : low) - m_near[k]) * m_inverse[k]);
      out = std::min(out, ((m_backward[k] ? low : high) - m_far[k]) * m_inverse[k]);
    }
    return in <= out * (1.0 + 1e-15) ? in * (1.0 - 1e-15) : std::numeric_limits<double>::infinity();
  }

 private:
  std::array<bool, 3> m_backward;
  std::array<double, 3> m_inverse, m_near, m_far;
};

// Never more than the squared distance of what is in the box.
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
      const double d =
          std::max({0.0, static_cast<double>(box.low[k]) - m_high[k], m_low[k] - static_cast<double>(box.high[k])});
      sum += d * d;
    }
    return sum * (1.0 - 1e-15);
  }

 private:
  Vec3 m_low, m_high;
};

}  // namespace

TriangleHierarchy::TriangleHierarchy(std::span<const Vec3> points, std::span<const Triangle> triangles)
    : m_points(points.begin(), points.end()), m_triangles(triangles.begin(), triangles.end()), m_frame(points) {
  std::vector<BoxedItem> items = boxedTriangles(points, triangles, m_frame, FlatTriangles::Keep);
  for (const BoxedItem& item : items)
    for (const std::uint32_t v : m_triangles[item.id()]) m_bounds.extend(m_points[v]);
  m_tree.build(items);
  m_order.reserve(items.size());
  for (const BoxedItem& item : items) m_order.push_back(item.id());
}

std::array<Vec3, 3> TriangleHierarchy::corners(std::uint32_t triangle) const {
  const Triangle& t = m_triangles[triangle];
  return {m_points[t[0]], m_points[t[1]], m_points[t[2]]};
}

std::optional<RayHit> TriangleHierarchy::firstHit(const Vec3& origin, const Vec3& direction) const {
  const double length = direction.cwiseAbs().maxCoeff();
  if (empty() || !(length > 0.0) || !direction.allFinite() || !m_frame.toFrame(origin).allFinite()) return std::nullopt;
  // By a power of two: exact, and nothing overflows below.
  const int exponent = std::ilogb(length);
  const Vec3 unit = direction.unaryExpr([&](double v) { return std::ldexp(v, -exponent); });
  const RaySlabs slabs(m_frame.toFrame(origin), unit);
  const RayTriangleTest test(origin, unit);

  RayHit best;
  best.distance = std::numeric_limits<double>::infinity();
  const auto limit = [&] { return best.distance * m_frame.scale(); };
  VisitStack stack;
  stack.push({0, slabs.enter(m_tree.node(0).box)});
  while (!stack.empty()) {
    const auto [node, bound] = stack.pop();
    if (bound > limit() || bound == std::numeric_limits<double>::infinity()) continue;
    if (!m_tree.node(node).isLeaf()) {
      const std::uint32_t right = rightChild(m_tree, node);
      stack.pushBoth({node + 1, slabs.enter(m_tree.node(node + 1).box)}, {right, slabs.enter(m_tree.node(right).box)},
                     limit());
      continue;
    }
    for (std::uint32_t i = m_tree.node(node).first(); i < m_tree.leafEnd(node); ++i) {
      const auto [a, b, c] = corners(m_order[i]);
      const auto distance = test.hit(a, b, c);
      if (!distance || *distance > best.distance) continue;
      if (*distance < best.distance || m_order[i] < best.triangle) best = {m_order[i], *distance};
    }
  }
  if (best.triangle == kNone) return std::nullopt;
  best.distance = std::ldexp(best.distance, -exponent);
  return best;
}

std::optional<NearestPoint> TriangleHierarchy::nearest(const Vec3& p, double limit) const {
  if (empty() || !p.allFinite() || !(limit > 0.0)) return std::nullopt;
  const PointToBox boxes(m_frame.toFrame(p));
  const double scale2 = m_frame.scale() * m_frame.scale();

  NearestPoint best;
  best.squaredDistance = limit * limit;
  VisitStack stack;
  stack.push({0, boxes.squaredDistance(m_tree.node(0).box)});
  while (!stack.empty()) {
    const auto [node, bound] = stack.pop();
    if (bound > best.squaredDistance * scale2) continue;
    if (!m_tree.node(node).isLeaf()) {
      const std::uint32_t right = rightChild(m_tree, node);
      stack.pushBoth({node + 1, boxes.squaredDistance(m_tree.node(node + 1).box)},
                     {right, boxes.squaredDistance(m_tree.node(right).box)}, best.squaredDistance * scale2);
      continue;
    }
    for (std::uint32_t i = m_tree.node(node).first(); i < m_tree.leafEnd(node); ++i) {
      const auto [a, b, c] = corners(m_order[i]);
      const Vec3 q = closestOnTriangle(p, a, b, c);
      const double distance = (q - p).squaredNorm();
      const bool tie = distance == best.squaredDistance && best.triangle != kNone && m_order[i] < best.triangle;
      if (distance < best.squaredDistance || tie) best = {m_order[i], q, distance};
    }
  }
  if (best.triangle == kNone) return std::nullopt;
  return best;
}

bool TriangleHierarchy::forEachInBox(const Box& box, const std::function<bool(std::uint32_t)>& visit) const {
  // Exactly as the boxes in the frame were made, so that nothing is lost to rounding.
  const Vec3 low = m_frame.toFrame(box.min());
  const Vec3 high = m_frame.toFrame(box.max());
  const auto apart = [&](const FloatBox& b) {
    for (Eigen::Index k = 0; k < 3; ++k)
      if (!(static_cast<double>(b.low[k]) <= high[k] && low[k] <= static_cast<double>(b.high[k]))) return true;
    return false;
  };
  for (std::uint32_t node = 0; node < m_tree.nodeCount();) {
    const BoxNode& n = m_tree.node(node);
    if (apart(n.box)) {
      node += n.size();
      continue;
    }
    if (n.isLeaf())
      for (std::uint32_t i = n.first(); i < m_tree.leafEnd(node); ++i) {
        const auto [a, b, c] = corners(m_order[i]);
        const Vec3 least = a.cwiseMin(b).cwiseMin(c);
        const Vec3 most = a.cwiseMax(b).cwiseMax(c);
        const bool meets = (least.array() <= box.max().array()).all() && (box.min().array() <= most.array()).all();
        if (meets && !visit(m_order[i])) return false;
      }
    ++node;
  }
  return true;
}

}  // namespace handwheel
