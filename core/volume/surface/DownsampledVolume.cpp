// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/surface/DownsampledVolume.h"

#include "volume/VolumeFilters.h"
#include "volume/VolumeSampler.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace handwheel {
namespace {

constexpr int kHalvedWindow = 2 * VolumeBlock::kSize + 1;  // voxels of the finer volume around a block, along an axis

// The blocks of the coarser volume to which those with material or samples add.
std::vector<VoxelIndex> halvedBlocks(const SparseVolume& volume) {
  std::vector<VoxelIndex> blocks;
  volume.forEach([&](const VoxelIndex& at, const SparseVolume::Content&) {
    for (int i = 0; i < 8; ++i)
      blocks.emplace_back((at.x() + (i & 1)) >> 1, (at.y() + (i >> 1 & 1)) >> 1, (at.z() + (i >> 2)) >> 1);
  });
  sortUnique(blocks);
  return blocks;
}

// Returns the uniform value of all blocks that a coarse block reads; none: they are not uniform.
std::optional<bool> uniformAround(const SparseVolume& volume, const VoxelIndex& block) {
  const bool isFull = volume.view(2 * block).isFull;
  for (int z = -1; z < 2; ++z)
    for (int y = -1; y < 2; ++y)
      for (int x = -1; x < 2; ++x) {
        const SparseVolume::View view = volume.view(2 * block + VoxelIndex(x, y, z));
        if (view.block || view.isFull != isFull) return std::nullopt;
      }
  return isFull;
}

SparseVolume::Content halvedContent(const SparseVolume& volume, const VoxelIndex& block) {
  if (const auto isFull = uniformAround(volume, block)) return {nullptr, *isFull};
  constexpr int n = kHalvedWindow;
  const auto windowIndex = [](int x, int y, int z) { return static_cast<std::size_t>((z * n + y) * n + x); };
  std::array<std::int16_t, std::size_t{n} * n * n> window;
  const VolumeSampler sampler(volume);
  const VoxelIndex first = 2 * VolumeBlock::kSize * block - VoxelIndex::Ones();
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) window[windowIndex(x, y, z)] = sampler.sample(first + VoxelIndex(x, y, z));
  auto samples = std::make_shared<VolumeBlock>();
  for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
    const VoxelIndex low = 2 * VoxelIndex(i & 7, i >> 3 & 7, i >> 6);
    std::int16_t deepest = VolumeBlock::kEmpty;
    for (int z = 0; z < 3; ++z)
      for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x)
          deepest = std::max(deepest, window[windowIndex(low.x() + x, low.y() + y, low.z() + z)]);
    // Samples at the limit remain at the limit.
    const bool isLimit = deepest == VolumeBlock::kEmpty || deepest == VolumeBlock::kFull;
    samples->depths[static_cast<std::size_t>(i)] = isLimit ? deepest : depthSample(0.5 * deepest / VolumeBlock::kUnit);
  }
  return contentOf(std::move(samples));
}

}  // namespace

SparseVolume downsampledVolume(const SparseVolume& volume) {
  const std::vector<VoxelIndex> blocks = halvedBlocks(volume);
  std::vector<SparseVolume::Content> contents(blocks.size());
  tbb::parallel_for(std::size_t{0}, blocks.size(),
                    [&](std::size_t i) { contents[i] = halvedContent(volume, blocks[i]); });
  SparseVolume made(volume.origin(), 2.0 * volume.voxel());
  for (std::size_t i = 0; i < blocks.size(); ++i) made.setContent(blocks[i], std::move(contents[i]));
  makeDistances(made, made.blocks(), DepthWindow::Beside::Kept);
  return made;
}

}  // namespace handwheel
