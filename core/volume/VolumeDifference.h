// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <vector>

// Where two volumes of one grid differ.
namespace handwheel {

inline SparseVolume::View viewOf(const SparseVolume::Content& content) {
  return {content.block.get(), content.isFull};
}

// Whether two blocks have the same samples, or are uniform alike.
bool isSameContent(const SparseVolume::View& a, const SparseVolume::View& b);

// The order of blocks in which they can be searched.
bool isBlockBefore(const VoxelIndex& a, const VoxelIndex& b);

// The blocks that differ, in that order. O(blocks); samples are compared only of those that are not shared.
std::vector<VoxelIndex> differingBlocks(const SparseVolume& a, const SparseVolume& b);

// Some blocks of a volume, and nothing else.
SparseVolume onlyBlocks(const SparseVolume& volume, const std::vector<VoxelIndex>& blocks);

}  // namespace handwheel
