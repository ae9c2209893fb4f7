// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/repair/DepthWindow.h"

#include <span>
#include <vector>

namespace handwheel {

// Turns the depths of blocks and of their neighbours into distances from the surface (DepthWindow::redistance()). Runs
// on all threads of the arena. The volume is unchanged if cancelled.
void makeDistances(SparseVolume& volume, std::span<const VoxelIndex> blocks, DepthWindow::Beside beside,
                   Progress progress = {});

// Smooths the steps of voxels on a surface: each depth becomes the mean of the 3³ depths around it. Walls thinner than
// about two voxels may vanish. Runs on all threads of the arena. The volume is unchanged if cancelled.
void smooth(SparseVolume& volume, Progress progress = {});

// Sorts blocks along z, y, x and removes duplicates. withNeighbours() first adds the 26 neighbours of each block.
void sortUnique(std::vector<VoxelIndex>& blocks);
std::vector<VoxelIndex> withNeighbours(std::span<const VoxelIndex> blocks);

// Returns true if the surface intersects neither a block nor its neighbours.
bool isFarFromSurface(const SparseVolume& volume, const VoxelIndex& block);
// Makes those of these blocks uniform that are no longer near the surface. Runs on all threads of the arena.
void dropFar(SparseVolume& volume, std::span<const VoxelIndex> blocks);

}  // namespace handwheel
