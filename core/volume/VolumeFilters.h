// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/repair/DepthWindow.h"

#include <span>
#include <vector>

namespace handwheel {

// Makes the depths of blocks distances from the surface (DepthWindow::redistance()). Those of these blocks and of the
// ones around them. On all threads of the arena; the volume is as it was once cancelled.
void makeDistances(SparseVolume& volume, std::span<const VoxelIndex> blocks, DepthWindow::Beside beside,
                   Progress progress = {});

// Takes the steps of voxels off a surface: each depth becomes the mean of 3³ around it. What is thinner than about two
// voxels may vanish. On all threads of the arena; the volume is as it was once cancelled.
void smooth(SparseVolume& volume, Progress progress = {});

// Blocks once each, sorted along z, y, x; and with the 26 around each.
void sortUnique(std::vector<VoxelIndex>& blocks);
std::vector<VoxelIndex> withNeighbours(std::span<const VoxelIndex> blocks);

// Whether no surface is in a block or in those around it.
bool isFarFromSurface(const SparseVolume& volume, const VoxelIndex& block);
// Makes those of these blocks uniform that are far from the surface: what was near one that has gone. On all threads of
// the arena.
void dropFar(SparseVolume& volume, std::span<const VoxelIndex> blocks);

}  // namespace handwheel
