// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "volume/SparseVolume.h"

#include <vector>

namespace handwheel {

struct ClayDab;

// Where clay is protected from dabs. For each voxel of a grid, also where there is no material, it is a share from 0,
// free, to 1, protected.
//
// A value, stored as a SparseVolume is, so copies share blocks. What it protects outside of all that was painted is
// uniform: nothing, or everything once it was inverted.
class ClayMask {
 public:
  // Of a grid without voxels; to be replaced.
  ClayMask() = default;
  // Protects nothing, in the grid of a volume.
  explicit ClayMask(const SparseVolume& volume) : m_values(volume.origin(), volume.voxel()) {}
  // From what values() and isInverted() gave.
  ClayMask(SparseVolume values, bool isInverted) : m_values(std::move(values)), m_isInverted(isInverted) {}

  // The shares of the voxels of one block. Valid as long as the mask stays as it is.
  class Block {
   public:
    Block(const SparseVolume::View& view, bool isInverted)
        : m_block(view.block), m_uniform(view.isFull != isInverted ? 1.0 : 0.0), m_isInverted(isInverted) {}

    bool isUniform() const { return !m_block; }
    bool isFree() const { return !m_block && m_uniform == 0.0; }
    // Of a voxel by its place in the block, as in VolumeBlock.
    double at(std::size_t i) const {
      if (!m_block) return m_uniform;
      const double share = (m_block->depths[i] - VolumeBlock::kEmpty) / kRange;  // exactly 1 of kFull
      return m_isInverted ? 1.0 - share : share;
    }

   private:
    static constexpr double kRange = VolumeBlock::kFull - VolumeBlock::kEmpty;

    const VolumeBlock* m_block;
    double m_uniform;
    bool m_isInverted;
  };
  Block block(const VoxelIndex& block) const { return {m_values.view(block), m_isInverted}; }
  // Of the voxel nearest to a place, mm; 0 where that is not finite, or farther away than a volume can be.
  double shareAt(const Vec3& place) const;

  // Whether it protects nothing.
  bool isFree() const { return m_values.isEmpty() && !m_isInverted; }
  // Whether its grid is that of a volume: else it says nothing about it.
  bool fits(const SparseVolume& volume) const {
    return m_values.origin() == volume.origin() && m_values.voxel() == volume.voxel();
  }
  // Whether it is the same as another one in the cells of a piece of 64³ voxels and beside them; false: not known to
  // be. O(1).
  bool isKnownSame(const ClayMask& other, const VoxelIndex& region) const;

  // Protects what a swept ball covers, up to the strength of the dab, or frees it with a strength below 0. Towards the
  // surface of the ball it does so less and less, over half of the radius with a falloff of 1, at most kWidestEdge and
  // at least kLeastEdge voxels. What is protected more than that already, or less, stays. Returns the blocks that are
  // others now; nothing happens for dabs that applyDab() refuses. On all threads of the arena; O(voxels of the edge).
  std::vector<VoxelIndex> paint(const ClayDab& dab);
  // Protects what was free and frees what was protected. O(1).
  void invert() { m_isInverted = !m_isInverted; }

  const SparseVolume& values() const { return m_values; }
  bool isInverted() const { return m_isInverted; }
  std::size_t bytes() const { return m_values.bytes(); }

  static constexpr double kLeastEdge = 2.0;    // voxels: no steps of voxels are left in the clay
  static constexpr double kWidestEdge = 24.0;  // voxels: what a large brush takes of memory

 private:
  SparseVolume m_values;  // shares from kEmpty (0) to kFull (1), before they are inverted
  bool m_isInverted = false;
};

}  // namespace handwheel
