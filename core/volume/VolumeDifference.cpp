// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeDifference.h"

#include <algorithm>
#include <optional>

namespace handwheel {

bool isSameContent(const SparseVolume::View& a, const SparseVolume::View& b) {
  if (!a.block || !b.block) return !a.block && !b.block && a.isFull == b.isFull;
  return a.block == b.block || a.block->depths == b.block->depths;
}

bool isBlockBefore(const VoxelIndex& a, const VoxelIndex& b) {
  for (int k = 2; k > 0; --k)
    if (a[k] != b[k]) return a[k] < b[k];
  return a[0] < b[0];
}

std::vector<VoxelIndex> differingBlocks(const SparseVolume& a, const SparseVolume& b) {
  std::vector<VoxelIndex> differing;
  // forEach() visits region by region, so shared regions are tested once each.
  std::optional<VoxelIndex> region;
  bool isShared = false;
  const auto isInShared = [&](const VoxelIndex& block) {
    const VoxelIndex of = SparseVolume::blockOf(block);  // 8³ blocks, as a block is of 8³ voxels
    if (region != of) isShared = a.sharesRegion(b, of);
    region = of;
    return isShared;
  };
  a.forEach([&](const VoxelIndex& at, const SparseVolume::Content& content) {
    if (!isInShared(at) && !isSameContent(viewOf(content), b.view(at))) differing.push_back(at);
  });
  b.forEach([&](const VoxelIndex& at, const SparseVolume::Content&) {
    if (isInShared(at)) return;
    const SparseVolume::View other = a.view(at);
    if (!other.block && !other.isFull) differing.push_back(at);
  });
  std::sort(differing.begin(), differing.end(), isBlockBefore);
  return differing;
}

SparseVolume onlyBlocks(const SparseVolume& volume, const std::vector<VoxelIndex>& blocks) {
  SparseVolume only(volume.origin(), volume.voxel());
  for (const VoxelIndex& block : blocks) only.setContent(block, volume.content(block));
  return only;
}

}  // namespace handwheel
