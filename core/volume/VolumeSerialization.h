// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"

#include <cstdint>
#include <span>
#include <vector>

namespace handwheel {

// The serial form of a volume: 16-bit numbers, in regions of 64³ voxels. It is used in the container, and between the
// program and the process that reads and writes VDB. Of a region: its number along x, y and z; for each of its 512
// blocks whether it is full, and whether it has samples; then the samples of those. All of 16 bits, the numbers as two
// of them, the lower half first.

// The regions that are not empty.
std::vector<VoxelIndex> regionsOf(const SparseVolume& volume);
void appendRegion(const SparseVolume& volume, const VoxelIndex& region, std::vector<std::int16_t>& numbers);

// Adds the regions in any numbers to the volume; false when what follows in them makes no sense. Memory: at most 64
// times the numbers.
bool readRegions(std::span<const std::int16_t> numbers, SparseVolume& volume);

// Gives full blocks beside empty ones samples, so that a surface lies between them: what was read may lack it. False
// where that would be more than so many.
bool closeOff(SparseVolume& volume, std::size_t most);

}  // namespace handwheel
