// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/CollisionBody.h"

#include <rapidcheck.h>

// Generators of random poses and collision bodies for property tests.
namespace handwheel::test {

inline double evenly(double low, double high) {
  return low + (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

inline Vec3 anyPosition(double far) {
  return {evenly(-far, far), evenly(-far, far), evenly(-far, far)};
}

inline Pose anyPose(double far) {
  Pose pose(Eigen::AngleAxisd(evenly(0.0, 3.1), (anyPosition(1.0) + Vec3(1e-3, 0, 0)).normalized()));
  pose.translation() = anyPosition(far);
  return pose;
}

// Returns the surface of a box with these half sizes around the origin.
inline TriangleSoup boxSoup(const Vec3& half) {
  TriangleSoup soup;
  for (int i = 0; i < 8; ++i)
    soup.points.emplace_back(i & 1 ? half.x() : -half.x(), i & 2 ? half.y() : -half.y(), i & 4 ? half.z() : -half.z());
  soup.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return soup;
}

// Returns a random point on the surface of a piece or inside it, in the frame of the piece.
inline Vec3 anyPointOf(const CollisionPiece& piece) {
  const Vec3 unit = anyPosition(1.0);
  switch (piece.kind) {
    case CollisionPiece::Kind::Ball:
      return piece.half.x() * unit / std::max(1.0, unit.norm());
    case CollisionPiece::Kind::Block:
      return piece.half.cwiseProduct(unit);
    default: {
      const double r = std::max(1.0, std::hypot(unit.x(), unit.y()));
      return {piece.half.x() * unit.x() / r, piece.half.x() * unit.y() / r, piece.half.z() * unit.z()};
    }
  }
}

inline CollisionPiece anyPiece(double far) {
  const Pose pose = anyPose(far);
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      return CollisionPiece::sphere(pose.translation(), evenly(1.0, 20.0));
    case 1:
      return CollisionPiece::box(pose, {evenly(1.0, 30.0), evenly(1.0, 30.0), evenly(1.0, 30.0)});
    default:
      return CollisionPiece::cylinder(pose, evenly(1.0, 20.0), evenly(1.0, 40.0));
  }
}

}  // namespace handwheel::test
