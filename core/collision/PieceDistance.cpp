// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/PieceDistance.h"

#include "collision/FclHierarchy.h"

#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <algorithm>
#include <cmath>
#include <optional>

namespace handwheel {

namespace {

using Kind = CollisionPiece::Kind;

// Largest error of FCL's iteration for two convex shapes, mm.
constexpr double kConvexTolerance = 1e-4;

std::shared_ptr<fcl::CollisionGeometryd> geometryOf(const CollisionPiece& piece) {
  switch (piece.kind) {
    case Kind::Ball:
      return std::make_shared<fcl::Sphered>(piece.half.x());
    case Kind::Block:
      return std::make_shared<fcl::Boxd>(2.0 * piece.half.x(), 2.0 * piece.half.y(), 2.0 * piece.half.z());
    case Kind::Cylinder:
      return std::make_shared<fcl::Cylinderd>(piece.half.x(), 2.0 * piece.half.z());
    case Kind::Mesh:
      return piece.mesh->hierarchy().model;
  }
  return nullptr;
}

// Computes the distance with FCL, which knows no tolerance: an existing result prunes whatever is further away. The
// distance is not below zero for meshes, and signed distances are wrong (issues 221, 245 and 491 of FCL), so these are
// not used.
double byFcl(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB, double enough) {
  const auto first = geometryOf(a), second = geometryOf(b);
  fcl::DistanceRequestd request;
  request.enable_nearest_points = false;
  request.enable_signed_distance = false;
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.distance_tolerance = 1e-6;
  fcl::DistanceResultd result;
  if (std::isfinite(enough)) result.min_distance = enough;
  fcl::distance(first.get(), poseA, second.get(), poseB, request, result);
  if (result.min_distance >= enough) return enough;
  const double slack = a.kind == Kind::Mesh && b.kind == Kind::Mesh ? 0.0 : kConvexTolerance;
  return std::max(0.0, result.min_distance - slack);
}

// Returns true if one of them is inside the other without meeting its surface. Needed for meshes, whose distance is to
// their triangles.
bool isWithin(const CollisionPiece& inner, const Pose& poseInner, const CollisionPiece& outer, const Pose& poseOuter) {
  if (outer.kind != Kind::Mesh || !outer.mesh->isClosed()) return false;
  Vec3 p = Vec3::Zero();  // a point of the inner piece
  if (inner.kind == Kind::Mesh) {
    const auto& model = *inner.mesh->hierarchy().model;
    if (model.num_vertices == 0) return false;
    p = model.vertices[0];
  }
  return outer.mesh->contains(poseOuter.inverse() * (poseInner * p));
}

}  // namespace

double distanceFromSolid(Kind kind, const Vec3& half, const Vec3& p) {
  if (kind == Kind::Ball) return p.norm() - half.x();
  if (kind == Kind::Block) {
    const Vec3 out = p.cwiseAbs() - half;
    const double inside = std::min(0.0, out.maxCoeff());
    return out.cwiseMax(0.0).norm() + inside;
  }
  const double across = std::hypot(p.x(), p.y()) - half.x(), along = std::abs(p.z()) - half.z();
  return std::hypot(std::max(across, 0.0), std::max(along, 0.0)) + std::min(0.0, std::max(across, along));
}

double pieceDistance(const CollisionPiece& a, const Pose& poseA, const CollisionPiece& b, const Pose& poseB,
                     double enough) {
  if (a.kind != Kind::Ball && b.kind == Kind::Ball) return pieceDistance(b, poseB, a, poseA, enough);
  if (a.kind == Kind::Ball && b.kind != Kind::Mesh)
    return distanceFromSolid(b.kind, b.half, poseB.inverse(Eigen::Isometry) * poseA.translation()) - a.half.x();
  for (const CollisionPiece* each : {&a, &b}) {
    if (each->kind == Kind::Mesh && each->mesh->bounds().isEmpty()) return std::numeric_limits<double>::infinity();
  }
  const double distance = byFcl(a, poseA, b, poseB, enough);
  if (distance > 0.0 && (isWithin(a, poseA, b, poseB) || isWithin(b, poseB, a, poseA))) return 0.0;
  return distance;
}

}  // namespace handwheel
