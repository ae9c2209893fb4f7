// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/ObstacleSet.h"

#include "collision/PieceDistance.h"

#include <algorithm>

namespace handwheel {

ObstacleSet::FourBounds::FourBounds() {
  turn.fill(Four::Zero());
  shift.fill(Four::Zero());
  half.fill(Four::Constant(-std::numeric_limits<double>::infinity()));  // unset bounds are infinitely far away
}

void ObstacleSet::FourBounds::set(Eigen::Index i, const Bound& bound) {
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column)
      turn[static_cast<std::size_t>(3 * row + column)][i] = bound.turn(row, column);
    shift[static_cast<std::size_t>(row)][i] = bound.shift[row];
    half[static_cast<std::size_t>(row)][i] = bound.half[row];
  }
}

ObstacleSet::FourBounds::Four ObstacleSet::FourBounds::squaredDistances(const Vec3& p) const {
  Four sum = Four::Zero();
  for (std::size_t row = 0; row < 3; ++row) {
    const Four at = turn[3 * row] * p.x() + turn[3 * row + 1] * p.y() + turn[3 * row + 2] * p.z() + shift[row];
    sum += (at.abs() - half[row]).max(0.0).square();
  }
  return sum;
}

void ObstacleSet::add(const CollisionBody& body, const Pose& pose, std::uint32_t owner) {
  for (const CollisionPiece& piece : body.pieces()) {
    const CollisionPiece placed = piece.moved(pose);
    const Pose inverse = Pose(placed.pose * Eigen::Translation3d(placed.boxCentre)).inverse(Eigen::Isometry);
    const std::size_t at = m_bounds.size();
    m_bounds.push_back({inverse.linear(), inverse.translation(), placed.boxHalf});
    if (at % 4 == 0) m_fours.emplace_back();
    m_fours.back().set(static_cast<Eigen::Index>(at % 4), m_bounds.back());
    m_obstacles.push_back({placed, owner});
  }
}

std::map<std::uint32_t, CollisionBody> ObstacleSet::bodies() const {
  std::map<std::uint32_t, std::vector<CollisionPiece>> pieces;
  for (const Obstacle& obstacle : m_obstacles) pieces[obstacle.owner].push_back(obstacle.piece);
  std::map<std::uint32_t, CollisionBody> bodies;
  for (auto& [owner, own] : pieces) bodies.emplace(owner, CollisionBody(std::move(own)));
  return bodies;
}

void ObstacleSet::findNear(const Vec3& centre, double radius, double enough, std::vector<std::uint32_t>& near,
                           QueryCounts* counts) const {
  near.clear();
  if (counts) counts->bounds += m_bounds.size();
  const double least = enough + radius;
  if (!(least > 0.0)) return;
  for (std::size_t i = 0; i < m_fours.size(); ++i) {
    const FourBounds::Four squares = m_fours[i].squaredDistances(centre);
    for (Eigen::Index k = 0; k < 4; ++k) {
      if (squares[k] < least * least) near.push_back(static_cast<std::uint32_t>(4 * i) + static_cast<std::uint32_t>(k));
    }
  }
}

ObstacleSet::Nearest ObstacleSet::distance(const CollisionBody& body, const Pose& pose, double enough,
                                           std::span<const std::uint32_t> leftOut, QueryCounts* counts) const {
  if (body.isEmpty()) return {enough};
  std::vector<std::uint32_t> near;
  findNear(pose * body.centre(), body.radius(), enough, near, counts);
  return distance(body, pose, enough, leftOut, near, counts);
}

ObstacleSet::Nearest ObstacleSet::distance(const CollisionBody& body, const Pose& pose, double enough,
                                           std::span<const std::uint32_t> leftOut, std::span<const std::uint32_t> among,
                                           QueryCounts* counts) const {
  Nearest nearest{enough};
  if (body.isEmpty() || among.empty()) return nearest;
  QueryCounts done;
  const Vec3 centre = pose * body.centre();
  for (const std::uint32_t i : among) {
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
    if (nearest.distance <= 0.0) break;
  }
  if (counts) {
    counts->bounds += done.bounds;
    counts->exact += done.exact;
  }
  return nearest;
}

}  // namespace handwheel
