// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionBody.h"

#include <algorithm>
#include <cmath>

// The distance of two convex shapes with a proof of it. Points are projected onto one shape and the other in turn, with
// the acceleration of Nesterov (1983); the plane between them bounds the distance from below. Independent of the
// algorithms of the program, and slow.
namespace handwheel::test {

struct ConvexSet {
  enum class Kind { Ball, Block, Cylinder, Triangle };
  Kind kind = Kind::Ball;
  Pose pose = Pose::Identity();
  Vec3 half = Vec3::Zero();
  std::array<Vec3, 3> corners{};  // corners of a triangle, in the world

  // Returns the nearest point of the set.
  Vec3 nearest(const Vec3& p) const {
    if (kind == Kind::Triangle) return nearestOnTriangle(p);
    Vec3 q = pose.inverse(Eigen::Isometry) * p;
    if (kind == Kind::Ball) q *= std::min(1.0, half.x() / std::max(q.norm(), 1e-300));
    if (kind == Kind::Block) q = q.cwiseMax(-half).cwiseMin(half);
    if (kind == Kind::Cylinder) {
      const double across = std::hypot(q.x(), q.y()), share = std::min(1.0, half.x() / std::max(across, 1e-300));
      q = {share * q.x(), share * q.y(), std::clamp(q.z(), -half.z(), half.z())};
    }
    return pose * q;
  }

  // Returns the largest scalar product of a direction and a point of the set.
  double reach(const Vec3& direction) const {
    if (kind == Kind::Triangle)
      return std::max({corners[0].dot(direction), corners[1].dot(direction), corners[2].dot(direction)});
    const Vec3 d = pose.linear().transpose() * direction;
    const double centre = pose.translation().dot(direction);
    if (kind == Kind::Ball) return centre + half.x() * d.norm();
    if (kind == Kind::Block) return centre + half.dot(d.cwiseAbs());
    return centre + half.x() * std::hypot(d.x(), d.y()) + half.z() * std::abs(d.z());
  }

 private:
  // By the regions of Voronoi of the triangle (Ericson 2005, section 5.1.5).
  Vec3 nearestOnTriangle(const Vec3& p) const {
    const auto& [a, b, c] = corners;
    const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap), d3 = ab.dot(bp), d4 = ac.dot(bp), d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + d1 / (d1 - d3) * ab;
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + d2 / (d2 - d6) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    const double whole = va + vb + vc;
    return a + vb / whole * ab + vc / whole * ac;
  }
};

// The distance lies between these bounds, mm.
struct DistanceBounds {
  double least = 0.0, most = 0.0;
};

inline DistanceBounds boundsOfDistance(const ConvexSet& a, const ConvexSet& b, const Vec3& start, double gap = 1e-7,
                                       double enough = std::numeric_limits<double>::infinity()) {
  constexpr int kMostSteps = 20'000;
  DistanceBounds bounds{0.0, std::numeric_limits<double>::infinity()};
  Vec3 x = a.nearest(start), y = x;
  double momentum = 1.0;
  for (int i = 0; i < kMostSteps; ++i) {
    const Vec3 on = b.nearest(x), apart = x - on;
    const double distance = apart.norm();
    bounds.most = std::min(bounds.most, distance);
    if (distance > 0.0) {
      const Vec3 normal = apart / distance;
      bounds.least = std::max(bounds.least, -a.reach(-normal) - b.reach(normal));
    }
    if (bounds.most - bounds.least <= gap || bounds.least >= enough) break;
    const Vec3 next = a.nearest(b.nearest(y));
    const double faster = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * momentum * momentum));
    const Vec3 step = next - x;
    // The momentum is given up where it leads away.
    const bool isAway = (y - next).dot(step) > 0.0;
    y = isAway ? next : Vec3(next + (momentum - 1.0) / faster * step);
    momentum = isAway ? 1.0 : faster;
    x = next;
  }
  return bounds;
}

}  // namespace handwheel::test
