// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/Penetration.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// Number of triangles whose directions are tried. Each direction is measured on all meeting pairs, so all triangles
// would take quadratic time in every cycle. Omitting a direction makes the depth larger, never too small: the result
// always separates the shapes. In slight contact few triangles meet, and the direction in which the shapes were apart
// before is tried in any case.
constexpr std::size_t kMostFaces = 16;

class PenetrationSearch {
 public:
  explicit PenetrationSearch(const std::vector<IntersectingShapes>& shapes) : m_shapes(shapes) {}

  // Tries a direction of any length; ignores a zero vector.
  void attempt(const Vec3& direction) {
    const double length = direction.norm();
    if (!(length > 0.0) || !std::isfinite(length)) return;
    const Penetration found = penetrationAlong(m_shapes, direction / length);
    if (m_hasAny && found.depth >= m_best.depth) return;
    m_best = found;
    m_hasAny = true;
  }
  void attemptBoth(const Vec3& direction) {
    attempt(direction);
    attempt(-direction);
  }

  // Searches around the best direction, for round shapes.
  void refine() {
    for (double step = 0.25; step > 1e-7; step *= 0.5) {
      for (int again = 0; again < 4; ++again) {
        const Vec3 n = m_best.normal, u = n.unitOrthogonal(), v = n.cross(u);
        const double before = m_best.depth;
        for (const Vec3& aside : {u, v, Vec3(-u), Vec3(-v)}) attempt(n + step * aside);
        if (m_best.depth >= before) break;
      }
    }
  }

  bool hasAny() const { return m_hasAny; }
  const Penetration& best() const { return m_best; }

 private:
  const std::vector<IntersectingShapes>& m_shapes;
  Penetration m_best;
  bool m_hasAny = false;
};

bool isTriangle(const ConvexShape& shape) {
  return shape.kind == CollisionPiece::Kind::Mesh;
}

Vec3 faceOf(const ConvexShape& triangle) {
  return (triangle.corners[1] - triangle.corners[0]).cross(triangle.corners[2] - triangle.corners[0]);
}

}  // namespace

Penetration penetrationAlong(const std::vector<IntersectingShapes>& shapes, const Vec3& direction) {
  Penetration found;
  found.depth = -std::numeric_limits<double>::infinity();
  found.normal = direction;
  for (const IntersectingShapes& pair : shapes) {
    const Vec3 deepest = pair.first.support(-direction);
    const double depth = direction.dot(pair.second.support(direction) - deepest);
    if (depth <= found.depth) continue;
    found.depth = depth;
    found.deepest = deepest;
  }
  return found;
}

Penetration minimumPenetration(const std::vector<IntersectingShapes>& shapes, const Vec3& last, bool isFirstClosed,
                               bool isSecondClosed) {
  PenetrationSearch search(shapes);
  search.attempt(last);
  const IntersectingShapes& some = shapes.front();
  for (const ConvexShape* shape : {&some.first, &some.second}) {
    if (isTriangle(*shape)) continue;
    for (Eigen::Index i = 0; i < 3; ++i) search.attemptBoth(shape->pose.linear().col(i));
  }
  for (std::size_t i = 0; i < std::min(kMostFaces, shapes.size()); ++i) {
    if (isTriangle(shapes[i].first))
      isFirstClosed ? search.attempt(-faceOf(shapes[i].first)) : search.attemptBoth(faceOf(shapes[i].first));
    if (isTriangle(shapes[i].second))
      isSecondClosed ? search.attempt(faceOf(shapes[i].second)) : search.attemptBoth(faceOf(shapes[i].second));
  }
  if (!isTriangle(some.first) && !isTriangle(some.second)) {
    for (Eigen::Index i = 0; i < 9; ++i)
      search.attemptBoth(some.first.pose.linear().col(i / 3).cross(some.second.pose.linear().col(i % 3)));
    const Vec3 apart = some.first.centre() - some.second.centre();
    search.attemptBoth(apart);
    bool isRound = false;
    for (const ConvexShape* shape : {&some.first, &some.second}) {
      if (shape->kind != CollisionPiece::Kind::Cylinder) continue;
      const Vec3 axis = shape->pose.linear().col(2);
      search.attemptBoth(apart - apart.dot(axis) * axis);
      isRound = true;
    }
    if (isRound) search.refine();
  }
  // Triangles without area have no direction of their own.
  for (Eigen::Index axis = 0; axis < 3 && !search.hasAny(); ++axis) search.attemptBoth(Vec3::Unit(axis));
  return search.best();
}

SolidNearest nearestOfSolid(CollisionPiece::Kind kind, const Vec3& half, const Vec3& p) {
  if (kind == CollisionPiece::Kind::Ball) {
    const double far = p.norm();
    const Vec3 normal = far > 0.0 ? Vec3(p / far) : Vec3(Vec3::UnitZ());
    return {far - half.x(), half.x() * normal, normal};
  }
  Vec3 point = p, normal = Vec3::Zero();
  double inside = 0.0;
  if (kind == CollisionPiece::Kind::Block) {
    point = p.cwiseMax(-half).cwiseMin(half);
    Eigen::Index axis = 0;
    inside = (p.cwiseAbs() - half).maxCoeff(&axis);
    normal = std::copysign(1.0, p[axis]) * Vec3::Unit(axis);
  } else {
    const double across = std::hypot(p.x(), p.y()), most = std::min(across, half.x());
    const Vec3 out = across > 0.0 ? Vec3(p.x() / across, p.y() / across, 0.0) : Vec3(Vec3::UnitX());
    point = most * out + std::clamp(p.z(), -half.z(), half.z()) * Vec3::UnitZ();
    const double beyond = across - half.x(), above = std::abs(p.z()) - half.z();
    inside = std::max(beyond, above);
    normal = beyond > above ? out : Vec3(std::copysign(1.0, p.z()) * Vec3::UnitZ());
  }
  if (inside <= 0.0) return {inside, p - inside * normal, normal};
  const double far = (p - point).norm();
  return {far, point, far > 0.0 ? Vec3((p - point) / far) : normal};
}

}  // namespace handwheel
