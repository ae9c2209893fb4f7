// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <array>
#include <memory>

namespace handwheel {

// The depths of a block and of four voxels around it, in voxels. After modification, they are written back as the
// content of the block.
class DepthWindow {
 public:
  static constexpr int kMargin = 4;
  static constexpr int kSide = VolumeBlock::kSize + 2 * kMargin;
  static constexpr double kLimit = VolumeBlock::kFull / VolumeBlock::kUnit;  // largest depth, voxels

  DepthWindow(const SparseVolume& volume, const VoxelIndex& block);

  // Returns true if the window has samples inside and outside.
  bool hasSurface() const;
  // Returns the depth of a voxel by its coordinates in the block, -kMargin to 7 + kMargin.
  float at(int x, int y, int z) const { return m_depths[index(x, y, z)]; }

  // Replaces each depth of the block by the mean of the (2 reach + 1)³ voxels around it; reach: 1 to kMargin.
  void average(int reach);
  // The treatment of the depths next to the surface when distances are restored.
  enum class Beside {
    Corrected,  // corrected to distances by their slope, for depths with a wrong gradient near the surface
    Kept,       // kept, for depths that are already distances
  };
  // Restores distances from the surface in all depths, by propagation from the depths next to it (Sethian 1996, but
  // without the heap, as depths end at four voxels).
  void redistance(Beside beside = Beside::Corrected);

  // Returns the content for these depths. Where isKept(x, y, z), the depths of the old content are kept. The content is
  // uniform if all depths are at the limit.
  template <class IsKept>
  SparseVolume::Content content(const SparseVolume::Content& old, IsKept isKept) const;

 private:
  using Depths = std::array<float, kSide * kSide * kSide>;
  static constexpr std::size_t index(int x, int y, int z) {
    return static_cast<std::size_t>(((z + kMargin) * kSide + y + kMargin) * kSide + x + kMargin);
  }

  Depths m_depths;
};

// Returns the content for these samples. It is uniform if all samples are at the same limit.
SparseVolume::Content contentOf(std::shared_ptr<VolumeBlock> block);
// Returns a copy of a content's samples for modification.
std::shared_ptr<VolumeBlock> samplesOf(const SparseVolume::Content& content);

template <class IsKept>
SparseVolume::Content DepthWindow::content(const SparseVolume::Content& old, IsKept isKept) const {
  std::shared_ptr<VolumeBlock> block = samplesOf(old);
  for (int z = 0; z < VolumeBlock::kSize; ++z)
    for (int y = 0; y < VolumeBlock::kSize; ++y)
      for (int x = 0; x < VolumeBlock::kSize; ++x)
        if (!isKept(x, y, z)) block->depths[VolumeBlock::at(x, y, z)] = depthSample(static_cast<double>(at(x, y, z)));
  return contentOf(std::move(block));
}

}  // namespace handwheel
