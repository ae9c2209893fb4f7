// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/OffsetDirection.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace handwheel {
namespace {

constexpr int kMostTurns = 100;        // of a direction towards a face that it lies behind
constexpr double kLongestMitre = 2.0;  // at a corner of three planes at right angles it is √3
// Of the squared cosines between normals and a direction, the mean from which on the planes determine the offset there:
// two that meet at 37°. Less is the noise of a smooth surface.
constexpr double kLeastSpread = 0.1;

// Bădoiu and Clarkson, "Smaller core-sets for balls", 2003.
Vec3 directionBehind(const std::vector<FaceAtVertex>& faces) {
  Vec3 middle = Vec3::Zero();
  for (const FaceAtVertex& f : faces) middle += f.normal / static_cast<double>(faces.size());
  for (int i = 1; i < kMostTurns; ++i) {
    const Vec3& worst = std::min_element(faces.begin(), faces.end(), [&](const FaceAtVertex& a, const FaceAtVertex& b) {
                          return a.normal.dot(middle) < b.normal.dot(middle);
                        })->normal;
    if (worst.dot(middle) > 0.0) return -middle.stableNormalized();
    middle += (worst - middle) / (i + 1.0);
  }
  return Vec3::Zero();
}

}  // namespace

Vec3 offsetBehind(const std::vector<FaceAtVertex>& around) {
  std::vector<FaceAtVertex> faces = around;
  std::erase_if(faces, [](const FaceAtVertex& f) { return f.normal.isZero(); });
  if (faces.empty()) return Vec3::Zero();
  Eigen::Matrix3d planes = Eigen::Matrix3d::Zero();
  Vec3 sum = Vec3::Zero();
  double angles = 0.0;
  for (const FaceAtVertex& f : faces) {
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
  return isBehindAll && offset.norm() <= kLongestMitre ? offset : directionBehind(faces);
}

}  // namespace handwheel
