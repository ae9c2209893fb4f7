// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeFilters.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <atomic>
#include <tuple>

namespace handwheel {
namespace {

bool hasSign(const SparseVolume::View& view, bool isInside) {
  if (!view.block) return view.isFull == isInside;
  return std::any_of(view.block->depths.begin(), view.block->depths.end(),
                     [&](std::int16_t depth) { return (depth > 0) == isInside; });
}

// Replaces blocks by the result of the work on a window around each, taken before all changes.
template <class Work>
void replaceBlocks(SparseVolume& volume, std::span<const VoxelIndex> blocks, Progress progress, Work work) {
  std::vector<SparseVolume::Content> made(blocks.size());
  std::atomic<std::size_t> done{0};
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
    if (progress.cancelled()) return;
    DepthWindow window(volume, blocks[i]);
    work(window);
    made[i] = window.content(volume.content(blocks[i]), [](int, int, int) { return false; });
    progress.set(static_cast<double>(++done) / static_cast<double>(blocks.size()));
  });
  if (progress.cancelled()) return;
  for (std::size_t i = 0; i < blocks.size(); ++i) volume.setContent(blocks[i], std::move(made[i]));
}

}  // namespace

void sortUnique(std::vector<VoxelIndex>& blocks) {
  const auto key = [](const VoxelIndex& at) { return std::tuple(at.z(), at.y(), at.x()); };
  std::sort(blocks.begin(), blocks.end(), [&](const VoxelIndex& a, const VoxelIndex& b) { return key(a) < key(b); });
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
}

std::vector<VoxelIndex> withNeighbours(std::span<const VoxelIndex> blocks) {
  std::vector<VoxelIndex> all;
  all.reserve(27 * blocks.size());
  for (const VoxelIndex& at : blocks)
    for (int k = 0; k < 27; ++k) all.emplace_back(at + VoxelIndex(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1));
  sortUnique(all);
  return all;
}

bool isFarFromSurface(const SparseVolume& volume, const VoxelIndex& block) {
  const SparseVolume::View here = volume.view(block);
  const bool isInside = here.block ? here.block->depths.front() > 0 : here.isFull;
  for (int k = 0; k < 27; ++k)
    if (hasSign(volume.view(block + VoxelIndex(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1)), !isInside)) return false;
  return true;
}

void dropFar(SparseVolume& volume, std::span<const VoxelIndex> blocks) {
  std::vector<char> isFar(blocks.size(), 0);  // not of bits: written by several threads
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
    isFar[i] = volume.view(blocks[i]).block && isFarFromSurface(volume, blocks[i]);
  });
  for (std::size_t i = 0; i < blocks.size(); ++i)
    if (isFar[i]) volume.setContent(blocks[i], {nullptr, volume.view(blocks[i]).block->depths.front() > 0});
}

void makeDistances(SparseVolume& volume, std::span<const VoxelIndex> blocks, DepthWindow::Beside beside,
                   Progress progress) {
  replaceBlocks(volume, withNeighbours(blocks), progress, [&](DepthWindow& window) { window.redistance(beside); });
}

void smooth(SparseVolume& volume, Progress progress) {
  replaceBlocks(volume, volume.blocks(), progress, [](DepthWindow& window) {
    window.average(1);
    window.redistance();
  });
}

}  // namespace handwheel
