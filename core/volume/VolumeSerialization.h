// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <cstdint>
#include <span>
#include <vector>

namespace handwheel {

// The serial form of a volume: 16-bit numbers, in regions of 64³ voxels. It is used in the container, and between the
// program and the process that reads and writes VDB files. A region consists of its index along x, y and z; a bit for
// each of its 512 blocks that is set if the block is full; a bit for each block that is set if the block has samples;
// and the samples of these blocks. The index along an axis consists of two numbers, the lower half first.

// Returns the regions that are not empty.
std::vector<VoxelIndex> regionsOf(const SparseVolume& volume);
void appendRegion(const SparseVolume& volume, const VoxelIndex& region, std::vector<std::int16_t>& numbers);

// Adds the serialised regions to the volume; returns false if the numbers are malformed. The volume takes at most 64
// times as much memory as the numbers.
bool readRegions(std::span<const std::int16_t> numbers, SparseVolume& volume);

// Gives samples to full blocks beside empty ones, so that a surface lies between them; files may lack these samples.
// Returns false if there are more than `most` such blocks.
bool closeOff(SparseVolume& volume, std::size_t most);

}  // namespace handwheel
