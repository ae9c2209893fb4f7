// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/CollisionBody.h"

#include "collision/PieceDistance.h"

#include <algorithm>

namespace handwheel {

namespace {

CollisionPiece bounded(CollisionPiece piece, const Vec3& boxCentre, const Vec3& boxHalf, double radius) {
  piece.boxCentre = boxCentre;
  piece.boxHalf = boxHalf;
  piece.centre = piece.pose * boxCentre;
  piece.radius = radius;
  return piece;
}

}  // namespace

CollisionPiece CollisionPiece::sphere(const Vec3& centre, double radius) {
  CollisionPiece piece{.kind = Kind::Ball, .pose = Pose(Eigen::Translation3d(centre)), .half = Vec3(radius, 0, 0)};
  return bounded(std::move(piece), Vec3::Zero(), Vec3::Constant(radius), radius);
}

CollisionPiece CollisionPiece::box(const Pose& pose, const Vec3& size) {
  return bounded({.kind = Kind::Block, .pose = pose, .half = 0.5 * size}, Vec3::Zero(), 0.5 * size, 0.5 * size.norm());
}

CollisionPiece CollisionPiece::cylinder(const Pose& pose, double radius, double length) {
  const Vec3 half(radius, 0.0, 0.5 * length);
  return bounded({.kind = Kind::Cylinder, .pose = pose, .half = half}, Vec3::Zero(), Vec3(radius, radius, 0.5 * length),
                 half.norm());
}

CollisionPiece CollisionPiece::ofMesh(const Pose& pose, std::shared_ptr<const CollisionMesh> mesh) {
  const Box& bounds = mesh->bounds();
  const bool isEmpty = bounds.isEmpty();
  const Vec3 half = isEmpty ? Vec3(Vec3::Zero()) : Vec3(0.5 * bounds.sizes());
  const Vec3 centre = isEmpty ? Vec3(Vec3::Zero()) : Vec3(bounds.center());
  return bounded({.kind = Kind::Mesh, .pose = pose, .mesh = std::move(mesh)}, centre, half, half.norm());
}

CollisionPiece CollisionPiece::moved(const Pose& by) const {
  CollisionPiece piece = *this;
  piece.pose = by * pose;
  piece.centre = by * centre;
  return piece;
}

CollisionBody::CollisionBody(std::vector<CollisionPiece> pieces) : m_pieces(std::move(pieces)) {
  if (m_pieces.empty()) return;
  Box box;
  for (const CollisionPiece& piece : m_pieces) {
    box.extend(Vec3(piece.centre.array() - piece.radius));
    box.extend(Vec3(piece.centre.array() + piece.radius));
  }
  m_centre = box.center();
  for (const CollisionPiece& piece : m_pieces)
    m_radius = std::max(m_radius, (piece.centre - m_centre).norm() + piece.radius);
}

double distanceBetween(const CollisionBody& a, const Pose& poseA, const CollisionBody& b, const Pose& poseB,
                       double enough, QueryCounts* counts) {
  if (a.isEmpty() || b.isEmpty()) return std::numeric_limits<double>::infinity();
  const double apart = (poseA * a.centre() - poseB * b.centre()).norm() - a.radius() - b.radius();
  if (apart >= enough) return apart;
  const Pose toA = poseA.inverse(Eigen::Isometry) * poseB;
  double least = enough;
  QueryCounts done;
  const auto isApart = [&](const Vec3& from, const Vec3& to, double radii) {
    return least + radii <= 0.0 || (to - from).squaredNorm() >= (least + radii) * (least + radii);
  };
  for (const CollisionPiece& second : b.pieces()) {
    const Vec3 centre = toA * second.centre;
    if (isApart(a.centre(), centre, a.radius() + second.radius)) continue;
    for (const CollisionPiece& first : a.pieces()) {
      ++done.bounds;
      if (isApart(first.centre, centre, first.radius + second.radius)) continue;
      ++done.exact;
      const bool areBalls = first.kind == CollisionPiece::Kind::Ball && second.kind == CollisionPiece::Kind::Ball;
      least = std::min(least, areBalls ? (centre - first.centre).norm() - first.radius - second.radius
                                       : pieceDistance(first, poseA * first.pose, second, poseB * second.pose, least));
      if (least <= 0.0) break;
    }
    if (least <= 0.0) break;
  }
  if (counts) {
    counts->bounds += done.bounds;
    counts->exact += done.exact;
  }
  return least;
}

}  // namespace handwheel
