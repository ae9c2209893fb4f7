// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <optional>

namespace handwheel {

// Reads single samples of a volume, with a cache of the last blocks. The volume must outlive the sampler and must not
// change. A sampler must be used by one thread only; it neither locks nor allocates.
class VolumeSampler {
 public:
  explicit VolumeSampler(const SparseVolume& volume) : m_volume(volume) {}

  const SparseVolume& volume() const { return m_volume; }

  std::int16_t sample(const VoxelIndex& voxel) const {
    const SparseVolume::View& view = viewOf(SparseVolume::blockOf(voxel));
    if (!view.block) return view.isFull ? VolumeBlock::kFull : VolumeBlock::kEmpty;
    return view.block->depths[VolumeBlock::at(voxel.x() & 7, voxel.y() & 7, voxel.z() & 7)];
  }
  // Returns the samples of a voxel and its seven neighbours with greater indices, x fastest.
  std::array<std::int16_t, 8> samplesFrom(const VoxelIndex& voxel) const;

  // A depth below the surface and its gradient.
  struct Depth {
    double depth = 0.0;            // mm; limited to nearly four voxels inside and outside
    Vec3 gradient = Vec3::Zero();  // points inwards; its length is 1 near a smooth surface, 0 far from it
  };
  // Returns the depth at any point, interpolated linearly between the eight samples around it. Points that are not
  // finite, or beyond the largest index of a volume, are outside.
  Depth depthAt(const Vec3& p) const;
  // Returns only the depth, in voxels, at a point given in voxels.
  double depthInVoxels(const Vec3& at) const;
  // Returns the direction in which the depth decreases, from central differences of samples. It varies smoothly where
  // the surface is smooth. The vector is zero far from the surface.
  Vec3 normalAt(const Vec3& p) const;

 private:
  struct Known {
    VoxelIndex block = VoxelIndex::Zero();
    SparseVolume::View view;
    bool isRead = false;
  };

  const SparseVolume::View& viewOf(const VoxelIndex& block) const {
    Known& known = m_known[static_cast<std::size_t>((block.x() & 1) | (block.y() & 1) << 1 | (block.z() & 1) << 2)];
    if (!known.isRead || known.block != block) known = {block, m_volume.view(block), true};
    return known.view;
  }

  const SparseVolume& m_volume;
  mutable std::array<Known, 8> m_known;
};

// The intersection of a ray with the surface of a volume.
struct VolumeHit {
  Vec3 point;       // mm
  Vec3 normal;      // unit vector, outwards
  double distance;  // in units of the length of the ray's direction
};
// Returns the first intersection of a ray from outside with the surface of a volume. direction: any vector except zero.
// O(blocks along the ray).
std::optional<VolumeHit> firstHit(const SparseVolume& volume, const Vec3& origin, const Vec3& direction);

}  // namespace handwheel
