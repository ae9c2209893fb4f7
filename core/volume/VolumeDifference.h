// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <vector>

// The difference of two volumes with the same grid.
namespace handwheel {

inline SparseVolume::View viewOf(const SparseVolume::Content& content) {
  return {content.block.get(), content.isFull};
}

// Returns true if two blocks have equal samples or the same uniform value.
bool isSameContent(const SparseVolume::View& a, const SparseVolume::View& b);

// Returns true if a is before b in the strict order of blocks that sorting and binary search use.
bool isBlockBefore(const VoxelIndex& a, const VoxelIndex& b);

// Returns the blocks that differ, in the order of isBlockBefore(). O(blocks); only blocks that are not shared are
// compared sample by sample.
std::vector<VoxelIndex> differingBlocks(const SparseVolume& a, const SparseVolume& b);

// Returns a volume that contains only these blocks of another volume.
SparseVolume onlyBlocks(const SparseVolume& volume, const std::vector<VoxelIndex>& blocks);

}  // namespace handwheel
