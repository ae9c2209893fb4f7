// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proximity/TriangleHierarchy.h"

#include "proximity/BoxQueries.h"
#include "proximity/ClosestPoint.h"
#include "proximity/RayTriangle.h"
#include "proximity/SliverPieces.h"

#include <cmath>
#include <limits>

namespace handwheel {

TriangleHierarchy::TriangleHierarchy(std::span<const Vec3> points, std::span<const Triangle> triangles,
                                     Progress progress, Slivers slivers)
    : m_points(points.begin(), points.end()), m_triangles(triangles.begin(), triangles.end()), m_frame(points) {
  std::vector<BoxedItem> items = boxedTriangles(points, triangles, m_frame, FlatTriangles::Keep, progress);
  for (const BoxedItem& item : items)
    for (const std::uint32_t v : m_triangles[item.id()]) m_bounds.extend(m_points[v]);
  if (slivers == Slivers::Cut) splitSliverBoxes(items, m_points, m_triangles, m_frame);
  if (!m_tree.build(items, progress)) return;
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
  // Scaling by a power of two is exact and prevents overflow below.
  const int exponent = std::ilogb(length);
  const Vec3 unit = direction.unaryExpr([&](double v) { return std::ldexp(v, -exponent); });
  const RaySlabs slabs(m_frame.toFrame(origin), unit);
  const RayTriangleTest test(origin, unit);

  RayHit best;
  best.distance = std::numeric_limits<double>::infinity();
  visitBestFirst(
      m_tree, [&](const FloatBox& box) { return slabs.enter(box); }, [&] { return best.distance * m_frame.scale(); },
      [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) {
          const std::uint32_t t = m_order[i];
          const auto [a, b, c] = corners(t);
          const auto distance = test.hit(a, b, c);
          if (!distance || *distance > best.distance) continue;
          if (*distance < best.distance || t < best.triangle) best = {t, *distance};
        }
      });
  if (best.triangle == kNone) return std::nullopt;
  best.distance = std::ldexp(best.distance, -exponent);
  return best;
}

std::optional<NearestPoint> TriangleHierarchy::nearest(const Vec3& p, double limit) const {
  if (empty() || !p.allFinite() || !(limit > 0.0)) return std::nullopt;
  const PointToBox point(m_frame.toFrame(p));
  NearestPoint best;
  best.squaredDistance = limit * limit;
  visitBestFirst(
      m_tree, [&](const FloatBox& box) { return point.squaredDistance(box); },
      [&] { return best.squaredDistance * m_frame.scale() * m_frame.scale(); },
      [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) {
          const std::uint32_t t = m_order[i];
          const auto [a, b, c] = corners(t);
          const Vec3 q = closestOnTriangle(p, a, b, c);
          const double distance = (q - p).squaredNorm();
          const bool lowerNumber = distance == best.squaredDistance && best.triangle != kNone && t < best.triangle;
          if (distance < best.squaredDistance || lowerNumber) best = {t, q, distance};
        }
      });
  if (best.triangle == kNone) return std::nullopt;
  return best;
}

bool TriangleHierarchy::isWithin(const Vec3& p, double distance) const {
  if (empty() || !p.allFinite() || !(distance > 0.0)) return false;
  const PointToBox point(m_frame.toFrame(p));
  const double limit = distance * distance;
  bool isFound = false;
  visitBestFirst(
      m_tree, [&](const FloatBox& box) { return point.squaredDistance(box); },
      [&] { return isFound ? -1.0 : limit * m_frame.scale() * m_frame.scale(); },
      [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end && !isFound; ++i) {
          const auto [a, b, c] = corners(m_order[i]);
          isFound = (closestOnTriangle(p, a, b, c) - p).squaredNorm() < limit;
        }
      });
  return isFound;
}

bool TriangleHierarchy::forEachInBox(const Box& box, const std::function<bool(std::uint32_t)>& visit) const {
  // Computed exactly like the boxes in the frame, so that rounding loses no triangle.
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
