// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/OffsetDirection.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <optional>

namespace handwheel {
namespace {

constexpr double kLongestMitre = 2.0;  // at a corner of three planes at right angles it is √3
// Least mean of the squared cosines between normals and a direction at which the planes determine the offset there:
// that of two planes that meet at 37°. Less is the noise of a smooth surface.
constexpr double kLeastSpread = 0.1;

// Below this margin the direction is hardly behind the planes; rounding by the file could exceed it.
constexpr double kLeastMargin = 1e-3;
// Each step comes nearer to the origin; only rounding can cause this many.
constexpr int kMostSimplexSteps = 200;
// Rounding error of squared lengths of at most 1.
constexpr double kRounding = 1e-14;

// Up to four points, without memory of their own: this is asked for each division of a fan.
struct Simplex {
  std::array<Vec3, 4> points;
  std::size_t size = 0;

  void add(const Vec3& p) { points[size++] = p; }
};

// Returns the point nearest to the origin of the affine hull of some points; nothing if it is not within their convex
// hull, or if fewer points have the same affine hull.
std::optional<Vec3> nearestWithin(const Simplex& simplex) {
  using Edges = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, 3>;
  using Shares = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 3, 1>;
  const Vec3& p = simplex.points.front();
  if (simplex.size == 1) return p;
  Edges edges(3, static_cast<Eigen::Index>(simplex.size) - 1);
  for (std::size_t i = 1; i < simplex.size; ++i) edges.col(static_cast<Eigen::Index>(i) - 1) = simplex.points[i] - p;
  const Eigen::ColPivHouseholderQR<Edges> qr(edges);
  if (qr.rank() < edges.cols()) return std::nullopt;
  const Shares shares = qr.solve(-p);
  if (!(shares.minCoeff() >= 0.0 && shares.sum() <= 1.0)) return std::nullopt;
  return Vec3(p + edges * shares);
}

// Returns the same for the convex hull of the points, and removes those that it does not depend on.
Vec3 nearestOfSimplex(Simplex& simplex) {
  Vec3 nearest = simplex.points.front();
  Simplex best;
  best.add(nearest);
  for (unsigned set = 1; set < 1u << simplex.size; ++set) {
    Simplex some;
    for (std::size_t i = 0; i < simplex.size; ++i)
      if (set >> i & 1u) some.add(simplex.points[i]);
    const auto found = nearestWithin(some);
    if (!found || !(found->squaredNorm() < nearest.squaredNorm())) continue;
    nearest = *found;
    best = some;
  }
  simplex = best;
  return nearest;
}

}  // namespace

DirectionBehind widestBehind(std::vector<Vec3> normals) {
  std::erase_if(normals, [](const Vec3& n) { return n.isZero(); });
  if (normals.empty()) return {};
  Simplex simplex;
  simplex.add(normals.front());
  Vec3 nearest = normals.front();
  for (int i = 0; i < kMostSimplexSteps; ++i) {
    const Vec3& farthest = *std::min_element(
        normals.begin(), normals.end(), [&](const Vec3& a, const Vec3& b) { return a.dot(nearest) < b.dot(nearest); });
    if (farthest.dot(nearest) >= nearest.squaredNorm() - kRounding) break;
    simplex.add(farthest);
    nearest = nearestOfSimplex(simplex);
    if (simplex.size == 4) return {};  // the origin is among them
  }
  const double margin = nearest.norm();
  return margin < kLeastMargin ? DirectionBehind() : DirectionBehind{-nearest / margin, margin};
}

Vec3 offsetBehind(const std::vector<FaceAtVertex>& around) {
  std::vector<FaceAtVertex> faces = around;
  std::erase_if(faces, [](const FaceAtVertex& f) { return f.normal.isZero(); });
  if (faces.empty()) return Vec3::Zero();
  Eigen::Matrix3d planes = Eigen::Matrix3d::Zero();
  Vec3 sum = Vec3::Zero();
  double angles = 0.0;
  std::vector<Vec3> normals;
  for (const FaceAtVertex& f : faces) {
    normals.push_back(f.normal);
    planes += f.angle * f.normal * f.normal.transpose();
    sum += f.angle * f.normal;
    angles += f.angle;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(planes);
  Vec3 offset = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    if (!(axes.eigenvalues()[k] > kLeastSpread * angles)) continue;
    const Vec3 axis = axes.eigenvectors().col(k);
    offset -= axis.dot(sum) / axes.eigenvalues()[k] * axis;
  }
  const bool isBehindAll =
      std::all_of(faces.begin(), faces.end(), [&](const FaceAtVertex& f) { return f.normal.dot(offset) < -0.5; });
  return isBehindAll && offset.norm() <= kLongestMitre ? offset : widestBehind(normals).direction;
}

}  // namespace handwheel
