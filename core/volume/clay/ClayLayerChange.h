// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <array>
#include <memory>
#include <mutex>
#include <vector>

namespace handwheel {

// What a layer of clay changes: blocks of a volume before it and after it. No others are held, so that a layer keeps
// nothing of what the volume has been elsewhere.
//
// Depths end at four voxels, and a stroke may be deeper than that. So that a share of it moves the surface by that
// share, distances are also known beyond: from the samples near the surface the others of the changed blocks follow
// from neighbour to neighbour (Sethian 1996; of first order). They are computed when they are first asked for.
//
// Immutable; reading on several threads is safe.
class ClayLayerChange {
 public:
  // Of what a share of a layer gives: it never makes a block full or empty. From it on a depth is "at least so much".
  static constexpr int kDeepestSample = VolumeBlock::kFull - 1;
  static constexpr float kKnownDepth = 3.0f;  // voxels, up to which depths of all volumes are distances

  ClayLayerChange(const SparseVolume& base, const SparseVolume& top);
  ClayLayerChange(const ClayLayerChange&) = delete;
  ClayLayerChange& operator=(const ClayLayerChange&) = delete;

  // Of the changed blocks; there is nothing else in them.
  const SparseVolume& base() const { return m_base; }
  const SparseVolume& top() const { return m_top; }
  // That differ, in the order of isBlockBefore().
  const std::vector<VoxelIndex>& blocks() const { return m_blocks; }
  bool changes(const VoxelIndex& block) const;

  // Depths of the voxels of a changed block, in voxels.
  struct Distances {
    std::array<float, VolumeBlock::kCount> base;    // below the surface before the change, as far as it is
    std::array<float, VolumeBlock::kCount> change;  // what is to be added to have those after it; 0 where neither
                                                    // surface is near
  };
  // Null where nothing is changed. The first time O(voxels of all changed blocks).
  const Distances* distances(const VoxelIndex& block) const;

  // Of the changed blocks, before and after.
  std::size_t bytes() const;

 private:
  std::size_t numberOf(const VoxelIndex& block) const;

  std::vector<VoxelIndex> m_blocks;
  SparseVolume m_base, m_top;
  mutable std::once_flag m_once;
  mutable std::vector<Distances> m_distances;  // in the order of the blocks
};

}  // namespace handwheel
