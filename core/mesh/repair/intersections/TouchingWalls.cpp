// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/TouchingWalls.h"

#include "mesh/repair/intersections/SharedPlanes.h"
#include "mesh/structure/CancelPolling.h"
#include "proximity/TriangleHierarchy.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

using Vec2 = Eigen::Vector2d;
using Polygon = std::vector<Vec2>;

// Cosine of the angle between planes that face each other. Long, narrow triangles have imprecise normals; the distances
// of the corners from the plane decide.
constexpr double kFacing = -0.9;
// Width of an overlap, in units of the distance that rounding moves points by.
constexpr double kLeastWidth = 4.0;

// Returns the part of a polygon on the left of the line from a to b.
Polygon clipped(const Polygon& polygon, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const auto side = [&](const Vec2& p) { return d.x() * (p.y() - a.y()) - d.y() * (p.x() - a.x()); };
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    const double sp = side(p), sq = side(q);
    if (sp >= 0.0) kept.push_back(p);
    if ((sp > 0.0 && sq < 0.0) || (sp < 0.0 && sq > 0.0)) kept.push_back(p + sp / (sp - sq) * (q - p));
  }
  return kept;
}

double overlapArea(const Polygon& polygon) {
  double doubled = 0.0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 u = polygon[i] - polygon[0], v = polygon[i + 1] - polygon[0];
    doubled += u.x() * v.y() - u.y() * v.x();
  }
  return 0.5 * doubled;
}

double longestSide(const TrianglePoints& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

// A triangle and its plane.
struct Wall {
  explicit Wall(const TrianglePoints& corners)
      : points(corners), doubled((points[1] - points[0]).cross(points[2] - points[0])) {}

  bool faces(const Wall& other) const {
    return doubled.dot(other.doubled) < kFacing * doubled.norm() * other.doubled.norm();
  }

  // True if all corners of the other, smaller triangle are near the plane.
  bool liesAt(const Wall& other, double reach) const {
    const Vec3 normal = doubled.normalized();
    return std::all_of(other.points.begin(), other.points.end(),
                       [&](const Vec3& p) { return std::abs(normal.dot(p - points[0])) <= reach; });
  }

  bool overlaps(const Wall& other, double reach) const {
    const Vec3 right = (points[1] - points[0]).normalized(), up = doubled.normalized().cross(right);
    const auto flat = [&](const Vec3& p) { return Vec2((p - points[0]).dot(right), (p - points[0]).dot(up)); };
    Polygon common{flat(other.points[2]), flat(other.points[1]), flat(other.points[0])};
    for (std::size_t k = 0; k < 3; ++k) common = clipped(common, flat(points[k]), flat(points[(k + 1) % 3]));
    return overlapArea(common) > kLeastWidth * reach * std::min(longestSide(points), longestSide(other.points));
  }

  TrianglePoints points;
  Vec3 doubled;  // normal times twice the area
};

bool touch(const Wall& a, const Wall& b, double reach) {
  if (!a.faces(b)) return false;
  const bool isFirst = a.doubled.norm() > b.doubled.norm();
  const Wall &large = isFirst ? a : b, &small = isFirst ? b : a;
  return large.liesAt(small, reach) && large.overlaps(small, reach);
}

}  // namespace

std::vector<TrianglePair> findTouchingWalls(const TriangleSoup& soup, Progress progress) {
  std::vector<TrianglePair> found;
  const double reach = planarReach(soup);
  const TriangleHierarchy triangles(soup.points, soup.triangles, progress.part(0.0, 0.3));
  const auto wall = [&](std::uint32_t t) {
    const Triangle& c = soup.triangles[t];
    return Wall({soup.points[c[0]], soup.points[c[1]], soup.points[c[2]]});
  };
  for (std::uint32_t t = 0; t < soup.triangles.size(); ++t) {
    if (!pollProgress(t, soup.triangles.size(), progress.part(0.3, 1.0), kSearchesPerPoll)) return {};
    if (hasRepeatedVertex(soup.triangles[t])) continue;
    const Wall own = wall(t);
    Box box;
    for (const Vec3& p : own.points) box.extend(p);
    const Vec3 slack = Vec3::Constant(reach);
    triangles.forEachInBox(Box(box.min() - slack, box.max() + slack), [&](std::uint32_t other) {
      if (other > t && !hasRepeatedVertex(soup.triangles[other]) && touch(own, wall(other), reach))
        found.emplace_back(t, other);
      return found.size() < kMaxTrianglePairs;
    });
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace handwheel
