// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/ObstacleSet.h"

#include "collision/PieceDistance.h"

#include <algorithm>

namespace handwheel {

namespace {

// The distance of a point from a box around the origin; 0 inside.
double distanceFromBox(const Vec3& half, const Vec3& p) {
  return (p.cwiseAbs() - half).cwiseMax(0.0).norm();
}

}  // namespace

void ObstacleSet::add(const CollisionBody& body, const Pose& pose, std::uint32_t owner) {
  for (const CollisionPiece& piece : body.pieces()) {
    const CollisionPiece placed = piece.moved(pose);
    const Pose box = placed.pose * Eigen::Translation3d(placed.boxCentre);
    m_obstacles.push_back({placed, box.inverse(Eigen::Isometry), placed.boxHalf, owner});
  }
}

ObstacleSet::Nearest ObstacleSet::distance(const CollisionBody& body, const Pose& pose, double enough,
                                           std::span<const std::uint32_t> leftOut, QueryCounts* counts) const {
  Nearest nearest{enough};
  if (body.isEmpty()) return nearest;
  QueryCounts done;
  const Vec3 centre = pose * body.centre();
  for (const Obstacle& obstacle : m_obstacles) {
    if (std::find(leftOut.begin(), leftOut.end(), obstacle.owner) != leftOut.end()) continue;
    ++done.bounds;
    if (distanceFromBox(obstacle.boxHalf, obstacle.toBox * centre) - body.radius() >= nearest.distance) continue;
    for (const CollisionPiece& piece : body.pieces()) {
      ++done.bounds;
      const Vec3 inBox = obstacle.toBox * (pose * piece.centre);
      if (distanceFromBox(obstacle.boxHalf, inBox) - piece.radius >= nearest.distance) continue;
      ++done.exact;
      const bool isSimple = piece.kind == CollisionPiece::Kind::Ball && !obstacle.piece.mesh;
      const double distance =
          isSimple ? distanceFromSolid(obstacle.piece.kind, obstacle.piece.half, inBox) - piece.radius
                   : pieceDistance(piece, pose * piece.pose, obstacle.piece, obstacle.piece.pose, nearest.distance);
      if (distance < nearest.distance) nearest = {distance, obstacle.owner};
      if (nearest.distance <= 0.0) break;
    }
    if (nearest.distance <= 0.0) break;
  }
  if (counts) {
    counts->bounds += done.bounds;
    counts->exact += done.exact;
  }
  return nearest;
}

}  // namespace handwheel
