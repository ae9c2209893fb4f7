// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace handwheel {

// The change that a layer of clay makes: its changed blocks before and after. Other blocks of the volume are not
// stored.
//
// Stored depths end at four voxels, and a stroke may be deeper. Distances beyond that are propagated from the samples
// near the surface through the changed blocks (Sethian 1996; of first order), so that a fraction of the stroke moves
// the surface by that fraction. They are computed on first use.
//
// Objects are immutable, and may be read on several threads.
class ClayLayerChange {
 public:
  // Largest sample that a fraction of a layer produces, so that it never makes a block full or empty. A sample of this
  // size or more means at least this depth.
  static constexpr int kDeepestSample = VolumeBlock::kFull - 1;
  static constexpr float kKnownDepth = 3.0f;  // voxels; up to this depth, all volumes hold exact distances

  ClayLayerChange(const SparseVolume& base, const SparseVolume& top);
  ClayLayerChange(const ClayLayerChange&) = delete;
  ClayLayerChange& operator=(const ClayLayerChange&) = delete;

  // The volumes before and after the change. They contain only the changed blocks.
  const SparseVolume& base() const { return m_base; }
  const SparseVolume& top() const { return m_top; }
  // The blocks that differ, in the order of isBlockBefore().
  const std::vector<VoxelIndex>& blocks() const { return m_blocks; }
  bool changes(const VoxelIndex& block) const;

  // The depths of the voxels of a changed block, in voxels.
  struct Distances {
    std::array<float, VolumeBlock::kCount> base;  // distance below the surface before the change
    std::array<float, VolumeBlock::kCount>
        change;  // difference of the distance after the change; 0 if neither surface is near
  };
  // Returns the distances of a block, or null if it is unchanged. The first call takes O(voxels of all changed blocks).
  const Distances* distances(const VoxelIndex& block) const;

  // Returns the memory of the changed blocks before and after the change, bytes.
  std::size_t bytes() const;

 private:
  std::size_t numberOf(const VoxelIndex& block) const;

  std::vector<VoxelIndex> m_blocks;
  SparseVolume m_base, m_top;
  mutable std::once_flag m_once;
  mutable std::vector<Distances> m_distances;  // distances of the blocks, in the same order
};

}  // namespace handwheel
