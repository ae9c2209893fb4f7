// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "volume/SparseVolume.h"

#include <vector>

namespace handwheel {

struct ClayDab;

// The protection of clay from dabs. It is a fraction from 0 (free) to 1 (protected) for each voxel of a grid, including
// voxels without material.
//
// A value type that is stored as a SparseVolume, so copies share blocks. Outside the painted blocks, the mask is
// uniform: free, or protected if it was inverted.
class ClayMask {
 public:
  // Constructs a mask without a grid, which must be assigned to before use.
  ClayMask() = default;
  // Constructs a mask that protects nothing, in the grid of a volume.
  explicit ClayMask(const SparseVolume& volume) : m_values(volume.origin(), volume.voxel()) {}
  // Restores a mask from values() and isInverted().
  ClayMask(SparseVolume values, bool isInverted) : m_values(std::move(values)), m_isInverted(isInverted) {}

  // The protected fractions of one block. They are valid until the mask changes.
  class Block {
   public:
    Block(const SparseVolume::View& view, bool isInverted)
        : m_block(view.block), m_uniform(view.isFull != isInverted ? 1.0 : 0.0), m_isInverted(isInverted) {}

    bool isUniform() const { return !m_block; }
    bool isFree() const { return !m_block && m_uniform == 0.0; }
    // Returns the fraction of a voxel by its index in the block, in the order of VolumeBlock.
    double at(std::size_t i) const {
      if (!m_block) return m_uniform;
      const double share = (m_block->depths[i] - VolumeBlock::kEmpty) / kRange;  // exactly 1 for kFull
      return m_isInverted ? 1.0 - share : share;
    }

   private:
    static constexpr double kRange = VolumeBlock::kFull - VolumeBlock::kEmpty;

    const VolumeBlock* m_block;
    double m_uniform;
    bool m_isInverted;
  };
  Block block(const VoxelIndex& block) const { return {m_values.view(block), m_isInverted}; }
  // Returns the fraction of the voxel nearest to a point, mm. Returns 0 if the point is not finite, or beyond the
  // largest index of a volume.
  double shareAt(const Vec3& point) const;

  // Returns true if nothing is protected.
  bool isFree() const { return m_values.isEmpty() && !m_isInverted; }
  // Returns true if the mask has the grid of a volume. A mask with another grid does not apply to the volume.
  bool fits(const SparseVolume& volume) const {
    return m_values.origin() == volume.origin() && m_values.voxel() == volume.voxel();
  }
  // Returns true if the mask certainly equals another one in a piece of 64³ cells and beside it. If the result is
  // false, the masks may still be equal. O(1).
  bool isKnownSame(const ClayMask& other, const VoxelIndex& region) const;

  // Protects the voxels in a swept ball up to the strength of the dab, or frees them if the strength is negative. The
  // effect fades towards the surface of the ball. For a falloff of 1, it fades over half of the radius, but over at
  // least kLeastEdge and at most kWidestEdge voxels. Painting never reduces a higher protection, and freeing never
  // raises a lower one. Dabs that applyDab() refuses have no effect. Returns the blocks that changed. Runs on all
  // threads of the arena; O(voxels of the edge).
  std::vector<VoxelIndex> paint(const ClayDab& dab);
  // Exchanges free and protected voxels. O(1).
  void invert() { m_isInverted = !m_isInverted; }

  const SparseVolume& values() const { return m_values; }
  bool isInverted() const { return m_isInverted; }
  std::size_t bytes() const { return m_values.bytes(); }

  static constexpr double kLeastEdge = 2.0;    // voxels; a narrower edge would make visible steps in the clay
  static constexpr double kWidestEdge = 24.0;  // voxels; limits the memory of a large brush

 private:
  SparseVolume m_values;  // fractions from kEmpty (0) to kFull (1), before inversion
  bool m_isInverted = false;
};

}  // namespace handwheel
