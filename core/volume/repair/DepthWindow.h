// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <array>
#include <memory>

namespace handwheel {

// The depths of a block and of four voxels around it, in voxels. They are worked on and put back as the block's.
class DepthWindow {
 public:
  static constexpr int kMargin = 4;
  static constexpr int kSide = VolumeBlock::kSize + 2 * kMargin;
  static constexpr double kLimit = VolumeBlock::kFull / VolumeBlock::kUnit;  // of depths, voxels

  DepthWindow(const SparseVolume& volume, const VoxelIndex& block);

  // Whether it has both inside and outside.
  bool hasSurface() const;
  // Of a voxel by its place in the block, -kMargin to 7 + kMargin.
  float at(int x, int y, int z) const { return m_depths[index(x, y, z)]; }

  // Replaces each depth of the block by the mean over (2 reach + 1)³ voxels around; reach: 1 to kMargin.
  void average(int reach);
  // What becomes of the depths beside the surface when the others are made distances from it again.
  enum class Beside {
    Corrected,  // distances, too, by what their slope says; for depths that went all one way or another near it
    Kept,       // they are distances already
  };
  // Makes all depths distances from the surface again: from those beside it the others follow from neighbour to
  // neighbour (Sethian 1996, without his heap: depths end at four voxels).
  void redistance(Beside beside = Beside::Corrected);

  // The block of these depths; those of the old one where isKept(x, y, z). Uniform where all are at the limit.
  template <class IsKept>
  SparseVolume::Content content(const SparseVolume::Content& old, IsKept isKept) const;

 private:
  using Depths = std::array<float, kSide * kSide * kSide>;
  static constexpr std::size_t index(int x, int y, int z) {
    return static_cast<std::size_t>(((z + kMargin) * kSide + y + kMargin) * kSide + x + kMargin);
  }

  Depths m_depths;
};

// The content of a block with these samples: none where all are at the same limit.
SparseVolume::Content contentOf(std::shared_ptr<VolumeBlock> block);
// The samples of a content to be written to.
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
