// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/PieceDistance.h"

#include "collision/ClosestPoints.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

double distanceFromSolid(CollisionPiece::Kind kind, const Vec3& half, const Vec3& p) {
  if (kind == CollisionPiece::Kind::Ball) return p.norm() - half.x();
  if (kind == CollisionPiece::Kind::Block) {
    const Vec3 out = p.cwiseAbs() - half;
    const double inside = std::min(0.0, out.maxCoeff());
    return out.cwiseMax(0.0).norm() + inside;
  }
  const double across = std::hypot(p.x(), p.y()) - half.x(), along = std::abs(p.z()) - half.z();
  return std::hypot(std::max(across, 0.0), std::max(along, 0.0)) + std::min(0.0, std::max(across, along));
}

double pieceDistance(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB,
                     double enough) {
  PairHint hint;
  QueryCounts counts;
  return distanceBound(a, poseA, b, poseB, 0.0, enough, hint, counts);
}

}  // namespace handwheel
