// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/ConvexDistance.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// Relative to squared lengths: the improvement below which the iteration ends. Round shapes converge step by step.
constexpr double kConverged = 1e-12;
constexpr int kMostIterations = 200;
// Relative to lengths: the rounding of the points, below which two shapes meet.
constexpr double kMeeting = 1e-14;

// A point of the difference of two shapes, a point of the first less one of the second.
struct DifferencePoint {
  Vec3 at, first, second;
};

// Up to four points of the difference, and the point of their hull nearest to the origin as a mean of them.
struct DifferenceHull {
  std::array<DifferencePoint, 4> points;
  std::array<double, 4> shares{};
  std::size_t size = 0;

  Vec3 mean(Vec3 DifferencePoint::*of) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < size; ++i) sum += shares[i] * (points[i].*of);
    return sum;
  }
};

// The mean of some points, by their indices, that is nearest to the origin.
struct NearestMean {
  std::array<std::size_t, 4> of{};
  std::array<double, 4> shares{};
  std::size_t size = 0;
  double square = std::numeric_limits<double>::infinity();
};

const NearestMean& nearer(const NearestMean& a, const NearestMean& b) {
  return b.square < a.square ? b : a;
}

NearestMean nearestOn(const DifferenceHull& hull, std::size_t i, std::size_t j) {
  const Vec3 &a = hull.points[i].at, ab = hull.points[j].at - a;
  const double length = ab.squaredNorm();
  const double t = length > 0.0 ? std::clamp(-a.dot(ab) / length, 0.0, 1.0) : 0.0;
  if (t <= 0.0) return {{i}, {1.0}, 1, a.squaredNorm()};
  if (t >= 1.0) return {{j}, {1.0}, 1, hull.points[j].at.squaredNorm()};
  return {{i, j}, {1.0 - t, t}, 2, (a + t * ab).squaredNorm()};
}

// Finds the nearest point on a face, or else on its edges. The weights come from the scalar products of the edges,
// which stay exact for distant points; those of the areas at the corners do not.
NearestMean nearestOn(const DifferenceHull& hull, std::size_t i, std::size_t j, std::size_t k) {
  const Vec3 &a = hull.points[i].at, ab = hull.points[j].at - a, ac = hull.points[k].at - a;
  const double bb = ab.squaredNorm(), bc = ab.dot(ac), cc = ac.squaredNorm(), det = bb * cc - bc * bc;
  if (det > 1e-14 * bb * cc) {
    const double rb = -a.dot(ab), rc = -a.dot(ac);
    const double s = (rb * cc - rc * bc) / det, t = (rc * bb - rb * bc) / det;
    if (s > 0.0 && t > 0.0 && s + t < 1.0)
      return {{i, j, k}, {1.0 - s - t, s, t}, 3, (a + s * ab + t * ac).squaredNorm()};
  }
  return nearer(nearer(nearestOn(hull, i, j), nearestOn(hull, j, k)), nearestOn(hull, k, i));
}

bool holdsOrigin(const DifferenceHull& hull) {
  const Vec3& a = hull.points[0].at;
  Eigen::Matrix3d edges;
  for (Eigen::Index i = 0; i < 3; ++i) edges.col(i) = hull.points[static_cast<std::size_t>(i) + 1].at - a;
  const double volume = edges.determinant();
  if (std::abs(volume) <= 1e-14 * edges.colwise().norm().prod()) return false;
  const Vec3 shares = edges.inverse() * -a;
  return shares.minCoeff() >= 0.0 && shares.sum() <= 1.0;
}

// Keeps the points that the nearest one lies between. Returns false if the hull contains the origin.
bool reduce(DifferenceHull& hull) {
  NearestMean best;
  if (hull.size == 1) best = {{0}, {1.0}, 1, hull.points[0].at.squaredNorm()};
  if (hull.size == 2) best = nearestOn(hull, 0, 1);
  if (hull.size == 3) best = nearestOn(hull, 0, 1, 2);
  if (hull.size == 4) {
    if (holdsOrigin(hull)) return false;
    best = nearer(nearer(nearestOn(hull, 0, 1, 2), nearestOn(hull, 0, 1, 3)),
                  nearer(nearestOn(hull, 0, 2, 3), nearestOn(hull, 1, 2, 3)));
  }
  const auto points = hull.points;
  hull.size = best.size;
  for (std::size_t i = 0; i < best.size; ++i) {
    hull.points[i] = points[best.of[i]];
    hull.shares[i] = best.shares[i];
  }
  return true;
}

// Replaces the hull by its nearest point, which is one of the difference as both shapes are convex.
DifferenceHull merged(const DifferenceHull& hull) {
  DifferenceHull one;
  one.points[0] = {hull.mean(&DifferencePoint::at), hull.mean(&DifferencePoint::first),
                   hull.mean(&DifferencePoint::second)};
  one.shares[0] = 1.0;
  one.size = 1;
  return one;
}

}  // namespace

ConvexShape ConvexShape::ofSolid(const CollisionPiece& piece, const Pose& pose) {
  const bool isBall = piece.kind == CollisionPiece::Kind::Ball;
  return {.kind = piece.kind, .pose = pose, .half = isBall ? Vec3(Vec3::Zero()) : piece.half};
}

Vec3 ConvexShape::centre() const {
  return kind == CollisionPiece::Kind::Mesh ? Vec3((corners[0] + corners[1] + corners[2]) / 3.0) : pose.translation();
}

Vec3 ConvexShape::support(const Vec3& direction) const {
  switch (kind) {
    case CollisionPiece::Kind::Mesh: {
      const double a = corners[0].dot(direction), b = corners[1].dot(direction), c = corners[2].dot(direction);
      return a >= b ? (a >= c ? corners[0] : corners[2]) : (b >= c ? corners[1] : corners[2]);
    }
    case CollisionPiece::Kind::Ball:
      break;
    case CollisionPiece::Kind::Block: {
      const Vec3 d = pose.linear().transpose() * direction;
      return pose *
             Vec3(std::copysign(half.x(), d.x()), std::copysign(half.y(), d.y()), std::copysign(half.z(), d.z()));
    }
    case CollisionPiece::Kind::Cylinder: {
      const Vec3 d = pose.linear().transpose() * direction;
      const double across = std::hypot(d.x(), d.y()), share = across > 0.0 ? half.x() / across : 0.0;
      return pose * Vec3(share * d.x(), share * d.y(), std::copysign(half.z(), d.z()));
    }
  }
  return pose.translation();
}

ConvexNearest nearestOf(const ConvexShape& a, const ConvexShape& b, double enough) {
  DifferenceHull hull;
  Vec3 nearest = a.centre() - b.centre();
  double largest = 0.0;  // largest coordinate of the points, which their rounding is relative to
  double certain = 0.0;  // mm, how far a plane between the shapes is from both of them
  for (int i = 0; i < kMostIterations; ++i) {
    const Vec3 first = a.support(-nearest), second = b.support(nearest);
    const Vec3 at = first - second;
    const double square = nearest.squaredNorm(), ahead = nearest.dot(at);
    largest = std::max({largest, first.norm(), second.norm()});
    // Rounding may make the quotient too small although the product is not.
    if (ahead > 0.0 && ahead >= enough * std::sqrt(square)) return {std::max(enough, ahead / std::sqrt(square))};
    if (ahead > 0.0) certain = std::max(certain, ahead / std::sqrt(square));
    if (hull.size > 0 && square - ahead <= kConverged * square) break;
    const DifferenceHull before = hull;
    hull.points[hull.size++] = {at, first, second};
    if (!reduce(hull)) return {};
    nearest = hull.mean(&DifferencePoint::at);
    if (before.size > 0 && nearest.squaredNorm() >= square) {
      // On round shapes the points come to lie so close that their hull is lost in rounding. The nearest point so far
      // replaces them: on the line to the new one there is a nearer one.
      hull = merged(before);
      hull.points[hull.size++] = {at, first, second};
      reduce(hull);
      nearest = hull.mean(&DifferencePoint::at);
      if (nearest.squaredNorm() >= square) {
        hull = before;
        break;
      }
    }
    if (nearest.norm() <= kMeeting * largest) return {};
  }
  const Vec3 first = hull.mean(&DifferencePoint::first), second = hull.mean(&DifferencePoint::second);
  return {std::min(certain, hull.mean(&DifferencePoint::at).norm()), first, second};
}

}  // namespace handwheel
