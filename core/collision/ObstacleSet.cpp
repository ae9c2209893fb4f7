// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/ObstacleSet.h"

#include "collision/PieceDistance.h"

#include <algorithm>

namespace handwheel {

void ObstacleSet::add(const CollisionBody& body, const Pose& pose, std::uint32_t owner) {
  for (const CollisionPiece& piece : body.pieces()) {
    const CollisionPiece placed = piece.moved(pose);
    const Pose inverse = Pose(placed.pose * Eigen::Translation3d(placed.boxCentre)).inverse(Eigen::Isometry);
    m_bounds.push_back({inverse.linear(), inverse.translation(), placed.boxHalf});
    m_obstacles.push_back({placed, owner});
  }
}

ObstacleSet::Nearest ObstacleSet::distance(const CollisionBody& body, const Pose& pose, double enough,
                                           std::span<const std::uint32_t> leftOut, QueryCounts* counts) const {
  Nearest nearest{enough};
  if (body.isEmpty()) return nearest;
  QueryCounts done;
  const Vec3 centre = pose * body.centre();
  for (std::size_t i = 0; i < m_obstacles.size() && nearest.distance > 0.0; ++i) {
    const Bound& bound = m_bounds[i];
    ++done.bounds;
    if (bound.isApart(bound.inside(centre), nearest.distance + body.radius())) continue;
    const Obstacle& obstacle = m_obstacles[i];
    if (std::find(leftOut.begin(), leftOut.end(), obstacle.owner) != leftOut.end()) continue;
    for (const CollisionPiece& piece : body.pieces()) {
      ++done.bounds;
      const Vec3 inBox = bound.inside(pose * piece.centre);
      if (bound.isApart(inBox, nearest.distance + piece.radius)) continue;
      ++done.exact;
      const bool isSimple = piece.kind == CollisionPiece::Kind::Ball && !obstacle.piece.mesh;
      const double distance =
          isSimple ? distanceFromSolid(obstacle.piece.kind, obstacle.piece.half, inBox) - piece.radius
                   : pieceDistance(piece, pose * piece.pose, obstacle.piece, obstacle.piece.pose, nearest.distance);
      if (distance < nearest.distance) nearest = {distance, obstacle.owner};
      if (nearest.distance <= 0.0) break;
    }
  }
  if (counts) {
    counts->bounds += done.bounds;
    counts->exact += done.exact;
  }
  return nearest;
}

}  // namespace handwheel
