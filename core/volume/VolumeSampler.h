// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <optional>

namespace handwheel {

// Reads single samples of a volume, with a cache of the last blocks. The volume
// must outlive it and stay as it is. One thread; no lock, no memory of its own.
class VolumeSampler {
 public:
  explicit VolumeSampler(const SparseVolume& volume) : m_volume(volume) {}

  const SparseVolume& volume() const { return m_volume; }

  std::int16_t sample(const VoxelIndex& voxel) const {
    const SparseVolume::View& view = viewOf(SparseVolume::blockOf(voxel));
    if (!view.block) return view.isFull ? VolumeBlock::kFull : VolumeBlock::kEmpty;
    return view.block->depths[VolumeBlock::at(voxel.x() & 7, voxel.y() & 7, voxel.z() & 7)];
  }
  // Of a voxel and its neighbours towards greater numbers, x fastest.
  std::array<std::int16_t, 8> samplesFrom(const VoxelIndex& voxel) const;

  // A depth below the surface and how it grows.
  struct Depth {
    double depth = 0.0;            // mm; limited to nearly four voxels either way
    Vec3 gradient = Vec3::Zero();  // points inwards; of length 1 near a smooth surface, 0 far from it
  };
  // At any point, by linear interpolation between the eight samples around it. Of what is not finite, or further away
  // than a volume can be, empty.
  Depth depthAt(const Vec3& p) const;
  // The same without the gradient, of a place in voxels and in voxels.
  double depthInVoxels(const Vec3& at) const;
  // The direction in which depth decreases there, by differences between samples two voxels apart: smooth where the
  // surface is. Zero far from the surface.
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

// Where a ray meets the surface of a volume first from outside; none: nowhere. direction: any length above 0. The
// distance is in lengths of it. O(blocks along the ray).
struct VolumeHit {
  Vec3 point;   // mm
  Vec3 normal;  // outwards, of length 1
  double distance;
};
std::optional<VolumeHit> firstHit(const SparseVolume& volume, const Vec3& origin, const Vec3& direction);

}  // namespace handwheel
