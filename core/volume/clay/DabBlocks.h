// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/VolumeDifference.h"
#include "volume/clay/ClayDab.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

// Functions that dabs on volumes and on masks share.
namespace handwheel {

// A ball that is swept along a segment; lengths are in voxels of a grid.
struct SweptBall {
  Vec3 centre, displacement;  // the displacement ends at the centre
  double radius;

  SweptBall(const SparseVolume& grid, const ClayDab& dab)
      : centre((dab.centre - grid.origin()) / grid.voxel()),
        displacement(dab.displacement / grid.voxel()),
        radius(dab.radius / grid.voxel()) {}

  // Returns the depth of a point inside the swept ball.
  double inside(const Vec3& p) const {
    const double length = displacement.squaredNorm();
    const double share = length > 0.0 ? std::clamp((centre - p).dot(displacement) / length, 0.0, 1.0) : 0.0;
    return radius - (p - centre + share * displacement).norm();
  }
};

// Returns true if a dab is finite and small enough for a grid.
bool isSoundDab(const ClayDab& dab, const SparseVolume& grid);

inline VoxelIndex firstOf(const VoxelIndex& block) {
  return VolumeBlock::kSize * block;
}

inline constexpr double kHalfDiagonal = 6.1;  // voxels, distance from the centre of a block to its farthest samples

inline Vec3 middleOf(const VoxelIndex& block) {
  return firstOf(block).cast<double>() + Vec3::Constant(3.5);
}

// Returns the matching blocks within the bounding box of two points, extended by reach. All lengths are in voxels.
template <class Matches>
std::vector<VoxelIndex> blocksAround(const Vec3& a, const Vec3& b, double reach, Matches matches) {
  const VoxelIndex low = SparseVolume::blockOf((a.cwiseMin(b).array() - reach).floor().cast<int>().matrix());
  const VoxelIndex high = SparseVolume::blockOf((a.cwiseMax(b).array() + reach).ceil().cast<int>().matrix());
  std::vector<VoxelIndex> blocks;
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x)
        if (matches(VoxelIndex(x, y, z))) blocks.emplace_back(x, y, z);
  return blocks;
}

// Replaces the content of each block by the result of make(block). Returns the blocks that changed.
template <class Make>
std::vector<VoxelIndex> replace(SparseVolume& volume, const std::vector<VoxelIndex>& blocks, Make make) {
  std::vector<SparseVolume::Content> made(blocks.size());
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) { made[i] = make(blocks[i]); });
  std::vector<VoxelIndex> changed;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (isSameContent(volume.view(blocks[i]), viewOf(made[i]))) continue;
    volume.setContent(blocks[i], std::move(made[i]));
    changed.push_back(blocks[i]);
  }
  return changed;
}

}  // namespace handwheel
