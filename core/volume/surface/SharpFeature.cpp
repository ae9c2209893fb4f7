// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/SharpFeature.h"

#include "volume/VolumeSampler.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kDeepest = 1.9;                     // voxels: of samples whose neighbours have distances, too
constexpr double kSlope = 0.02;                      // largest deviation of the slope of distances from 1
constexpr double kSharp = 0.85;                      // largest cosine between normals at a sharp feature
constexpr double kFarAlongEdge = 10.0;               // voxels, along an edge
constexpr std::array kReaches{1.8, 1.4, 1.1, 0.85};  // voxels, distance of considered points from the centre of a cell
constexpr std::size_t kLeastPlanes = 6;
constexpr double kSame = 0.999;      // cosine between normals of the same plane
constexpr double kResidual = 0.03;   // voxels, largest RMS distance of planes from their common point
constexpr double kLeastShare = 0.1;  // least significant eigenvalue, as a share of the largest

// Returns the tangent planes at the nearest points of the surface: those that explain the depth of a sample and of its
// neighbours towards one of the eight octants. Beside an edge these are on one side only, and midway between two planes
// there are two.
std::vector<SharpFeature::Plane> planesAt(const VolumeSampler& sampler, const VoxelIndex& at) {
  std::vector<SharpFeature::Plane> planes;
  const auto depthAt = [&](const VoxelIndex& voxel) { return sampler.sample(voxel) / VolumeBlock::kUnit; };
  const double depth = depthAt(at);
  if (std::abs(depth) > kDeepest) return planes;
  for (int side = 0; side < 8; ++side) {
    const VoxelIndex step(side & 1 ? 1 : -1, side & 2 ? 1 : -1, side & 4 ? 1 : -1);
    Vec3 slope;
    for (int k = 0; k < 3; ++k) slope[k] = (depthAt(at + step[k] * VoxelIndex::Unit(k)) - depth) * step[k];
    const double steep = slope.norm();
    if (std::abs(steep - 1.0) > kSlope) continue;
    bool isPlane = true;
    for (int c = 3; c < 8 && isPlane; ++c) {
      const VoxelIndex away = step.cwiseProduct(VoxelIndex(c & 1, c >> 1 & 1, c >> 2));
      isPlane = std::abs(depth + slope.dot(away.cast<double>()) - depthAt(at + away)) < kSlope;
    }
    const Vec3 inwards = slope / steep;
    if (isPlane && std::none_of(planes.begin(), planes.end(),
                                [&](const SharpFeature::Plane& plane) { return plane.inwards.dot(inwards) > kSame; }))
      planes.push_back({at.cast<double>() - depth * inwards, inwards});
  }
  return planes;
}

// Returns true if the samples of a cell indicate a smooth surface, by the mean slopes on either side.
bool isSmooth(const VolumeSampler& sampler, const VoxelIndex& cell) {
  std::array<Vec3, 8> slopes;
  for (std::size_t c = 0; c < 8; ++c) {
    const auto corner = static_cast<int>(c);
    const VoxelIndex at = cell + VoxelIndex(corner & 1, corner >> 1 & 1, corner >> 2);
    for (int k = 0; k < 3; ++k)
      slopes[c][k] = (sampler.sample(at + VoxelIndex::Unit(k)) - sampler.sample(at - VoxelIndex::Unit(k))) /
                     (2.0 * VolumeBlock::kUnit);
    if (std::abs(slopes[c].norm() - 1.0) > kSlope || slopes[c].dot(slopes[0]) < kSharp) return false;
  }
  return true;
}

// Returns the middle of a line's part in a cell, or the given nearest point to the centre if the line misses the cell.
Vec3 inCell(const Vec3& nearest, const Vec3& along, const Vec3& centre) {
  double from = -kFarAlongEdge, to = kFarAlongEdge;
  for (int k = 0; k < 3; ++k) {
    const double off = nearest[k] - centre[k];
    if (std::abs(along[k]) < 1e-6) {
      if (std::abs(off) > 0.5) return nearest;
      continue;
    }
    const double a = (-0.5 - off) / along[k], b = (0.5 - off) / along[k];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return from < to ? Vec3(nearest + 0.5 * (from + to) * along) : nearest;
}

// Returns the point that is nearest to all planes; in undetermined directions, a point in the cell or beside its
// centre.
Vec3 nearestToAll(const std::vector<SharpFeature::Plane>& planes, const Vec3& centre) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Vec3 right = Vec3::Zero();
  for (const SharpFeature::Plane& plane : planes) {
    sum += plane.inwards * plane.inwards.transpose();
    right += plane.inwards * plane.inwards.dot(plane.foot - centre);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  const Vec3& values = solver.eigenvalues();
  Vec3 from = Vec3::Zero();
  for (Eigen::Index k = 0; k < 3; ++k)
    if (values[k] > kLeastShare * values[2]) {
      const Vec3 axis = solver.eigenvectors().col(k);
      from += axis * (axis.dot(right) / values[k]);
    }
  const bool isEdge = values[0] <= kLeastShare * values[2] && values[1] > kLeastShare * values[2];
  return isEdge ? inCell(centre + from, solver.eigenvectors().col(0), centre) : Vec3(centre + from);
}

// Returns the feature of planes if they do not form a smooth surface and all pass nearly through one point.
std::optional<SharpFeature> featureOfPlanes(std::vector<SharpFeature::Plane> planes, const Vec3& centre) {
  if (planes.size() < kLeastPlanes) return std::nullopt;
  const Vec3 some = planes.front().inwards;
  if (std::none_of(planes.begin(), planes.end(),
                   [&](const SharpFeature::Plane& plane) { return plane.inwards.dot(some) < kSharp; }))
    return std::nullopt;
  SharpFeature feature{nearestToAll(planes, centre), std::move(planes), true};
  Vec3 away = Vec3::Zero(), inwards = Vec3::Zero();
  double squares = 0.0;
  for (const SharpFeature::Plane& plane : feature.planes) {
    squares += std::pow(plane.inwards.dot(feature.point - plane.foot), 2.0);
    away += plane.foot - feature.point;
    inwards += plane.inwards;
  }
  if (std::sqrt(squares / static_cast<double>(feature.planes.size())) > kResidual) return std::nullopt;
  feature.isConvex = away.dot(inwards) > 0.0;
  return feature;
}

}  // namespace

std::optional<double> SharpFeature::crossing(const VoxelIndex& from, int axis, bool isInside) const {
  std::optional<double> share;
  for (const Plane& plane : planes) {
    const double rise = plane.inwards[axis];
    if ((rise > 0.0) == isInside || std::abs(rise) < 0.05) continue;
    const double at = plane.inwards.dot(plane.foot - from.cast<double>()) / rise;
    // Out of a convex shape the first plane counts, and into a concave one the last.
    const bool isFirst = isConvex == isInside;
    if (!share || (isFirst ? at < *share : at > *share)) share = at;
  }
  return share;
}

std::optional<SharpFeature> featureOf(const SparseVolume& volume, const VoxelIndex& cell) {
  const VolumeSampler sampler(volume);
  if (isSmooth(sampler, cell)) return std::nullopt;
  const Vec3 centre = cell.cast<double>() + Vec3::Constant(0.5);
  std::vector<SharpFeature::Plane> all;
  for (int z = -2; z < 4; ++z)
    for (int y = -2; y < 4; ++y)
      for (int x = -2; x < 4; ++x)
        for (const SharpFeature::Plane& plane : planesAt(sampler, cell + VoxelIndex(x, y, z))) all.push_back(plane);
  // Beside a corner of three planes the nearest two have their edge in the cell.
  std::optional<SharpFeature> best;
  for (const double reach : kReaches) {
    std::vector<SharpFeature::Plane> near;
    for (const SharpFeature::Plane& plane : all)
      if ((plane.foot - centre).norm() < reach) near.push_back(plane);
    const auto feature = featureOfPlanes(std::move(near), centre);
    if (!feature) continue;
    if (!best) best = feature;
    if ((feature->point - centre).cwiseAbs().maxCoeff() <= 0.5) return feature;
  }
  return best;
}

}  // namespace handwheel
