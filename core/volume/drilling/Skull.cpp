// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/Skull.h"

#include "volume/repair/DepthWindow.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

struct Ellipsoid {
  Vec3 centre, half;

  // Returns the depth below its surface, divided by the length of the gradient; exact to first order beside the
  // surface, and on the axes.
  double depth(const Vec3& p) const {
    const Vec3 q = (p - centre).cwiseQuotient(half);
    const double out = q.norm(), slope = q.cwiseQuotient(half).norm();
    return slope > 0.0 ? out * (1.0 - out) / slope : half.minCoeff();
  }
};

const Ellipsoid kFace{{0.0, -50.0, -50.0}, {56.0, 38.0, 46.0}};

// Bone is inside one of the first bodies and in none of the second, which are subtracted.
struct SkullBodies {
  std::vector<Ellipsoid> solid{{Vec3::Zero(), Skull::kOuter}, kFace};
  std::vector<Ellipsoid> hollow{{Vec3::Zero(), Skull::kInner},                // the room within the inner table
                                {{-30.0, -84.0, -44.0}, {18.0, 24.0, 16.0}},  // orbits
                                {{30.0, -84.0, -44.0}, {18.0, 24.0, 16.0}},
                                {{0.0, -88.0, -68.0}, {11.0, 22.0, 14.0}},  // the opening of the nose
                                {{0.0, 18.0, -66.0}, {15.0, 18.0, 16.0}}};  // the great foramen

  // The depth of the bone, from what it is without all of them.
  double depthAt(const Vec3& p, double depth) const {
    for (const Ellipsoid& body : solid) depth = std::max(depth, body.depth(p));
    for (const Ellipsoid& body : hollow) depth = std::min(depth, -body.depth(p));
    return depth;
  }
};

const SkullBodies& allBodies() {
  static const SkullBodies all;
  return all;
}

constexpr double kSkullDepths = DepthWindow::kMargin;  // voxels from the surface that depths reach
// Voxels from the middle of a block to its farthest samples; three times as depths are of first order only, of
// ellipsoids of which no axis is longer than two of another.
constexpr double kFarInBlock = 3.0 * 6.1;

SparseVolume::Content blockAt(const SparseVolume& skull, const VoxelIndex& block) {
  const VoxelIndex first = VolumeBlock::kSize * block;
  const Vec3 middle = skull.origin() + skull.voxel() * (first.cast<double>() + Vec3::Constant(3.5));
  const double far = skull.voxel() * (kSkullDepths + kFarInBlock);
  const double depth = Skull::depthAt(middle);
  if (std::abs(depth) > far) return {nullptr, depth > 0.0};
  // Keeps the one or two bodies with a surface nearby; the others are beyond the depths of all samples.
  SkullBodies near = allBodies();
  const auto isWithin = [&](const Ellipsoid& body) { return body.depth(middle) > far; };
  const auto isFarFrom = [&](const Ellipsoid& body) { return body.depth(middle) < -far; };
  const double without = std::any_of(near.solid.begin(), near.solid.end(), isWithin) ? far : -far;
  std::erase_if(near.solid, [&](const Ellipsoid& body) { return without > 0.0 || isFarFrom(body); });
  std::erase_if(near.hollow, isFarFrom);
  auto samples = std::make_shared<VolumeBlock>();
  for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
    const Vec3 p = skull.centre(first + VoxelIndex(i & 7, i >> 3 & 7, i >> 6));
    samples->depths[static_cast<std::size_t>(i)] = depthSample(near.depthAt(p, without) / skull.voxel());
  }
  return contentOf(std::move(samples));
}

}  // namespace

double Skull::depthAt(const Vec3& p) {
  return allBodies().depthAt(p, -std::numeric_limits<double>::infinity());
}

SparseVolume skullOfVoxels(double voxel) {
  SparseVolume skull(Vec3::Zero(), voxel);
  const Vec3 low = -Skull::kOuter.cwiseMax(kFace.half - kFace.centre);
  const Vec3 high = Skull::kOuter.cwiseMax(kFace.half + kFace.centre);
  const auto blockOf = [&](const Vec3& p, double margin) {
    const Vec3 voxels = (p.array() / voxel + margin).floor();
    return SparseVolume::blockOf(voxels.cast<int>());
  };
  const VoxelIndex from = blockOf(low, -kSkullDepths), to = blockOf(high, kSkullDepths);
  const VoxelIndex count = to - from + VoxelIndex::Ones();
  const auto inLayer = static_cast<std::size_t>(count.x()) * static_cast<std::size_t>(count.y());
  std::vector<SparseVolume::Content> layer(inLayer);
  for (int z = from.z(); z <= to.z(); ++z) {
    const auto blockIndex = [&](std::size_t i) {
      const int at = static_cast<int>(i);
      return VoxelIndex(from.x() + at % count.x(), from.y() + at / count.x(), z);
    };
    tbb::parallel_for(std::size_t{0}, inLayer, [&](std::size_t i) { layer[i] = blockAt(skull, blockIndex(i)); });
    for (std::size_t i = 0; i < inLayer; ++i) {
      if (layer[i].block || layer[i].isFull) skull.setContent(blockIndex(i), std::move(layer[i]));
      layer[i] = {};
    }
  }
  return skull;
}

const SparseVolume& shippedSkull() {
  static const SparseVolume skull = skullOfVoxels(kSkullVoxel);
  return skull;
}

std::vector<SolidBall> skullBrain() {
  return {{{0.0, 0.0, 0.0}, 56.0}, {{0.0, -26.0, 0.0}, 50.0}, {{0.0, 28.0, 0.0}, 49.0}};
}

SkullSite skullSite() {
  const double x = 30.0, y = -35.0;
  const Vec3& half = Skull::kOuter;
  const double z = half.z() * std::sqrt(1.0 - std::pow(x / half.x(), 2) - std::pow(y / half.y(), 2));
  const Vec3 entry(x, y, z);
  return {entry, -entry.cwiseQuotient(half.cwiseProduct(half)).normalized()};
}

}  // namespace handwheel
