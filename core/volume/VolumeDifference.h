// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <vector>

// The difference of two volumes of one grid.
namespace handwheel {

inline SparseVolume::View viewOf(const SparseVolume::Content& content) {
  return {content.block.get(), content.isFull};
}

// Returns true if two blocks have equal samples or the same uniform value.
bool isSameContent(const SparseVolume::View& a, const SparseVolume::View& b);

// Strict order of blocks, for sorting and binary search.
bool isBlockBefore(const VoxelIndex& a, const VoxelIndex& b);

// Returns the blocks that differ, in the order of isBlockBefore(). O(blocks); only blocks that are not shared are
// compared by samples.
std::vector<VoxelIndex> differingBlocks(const SparseVolume& a, const SparseVolume& b);

// Returns a volume with only these blocks of another.
SparseVolume onlyBlocks(const SparseVolume& volume, const std::vector<VoxelIndex>& blocks);

}  // namespace handwheel
