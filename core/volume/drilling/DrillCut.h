// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/SparseVolume.h"
#include "volume/drilling/DrillBit.h"

#include <limits>
#include <vector>

namespace handwheel {

// The material that a drill head removes from a volume on a short move.
struct DrillCut {
  double removed = 0.0;      // mm³
  Vec3 push = Vec3::Zero();  // of length 1: where the head pushes what it takes, by A-8; 0: it took nothing
  std::vector<VoxelIndex> changedBlocks;  // in an order that depends on the arguments alone
};

// A way of a head.
struct DrillMove {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // of the centre, mm
  Vec3 axis = Vec3::UnitZ();                    // to the shank, of length 1
  // η of (3-21): what a voxel in the head loses at most, in lengths of the way. At least 1; below it material would
  // stay in the head of a drill that goes on. Infinite: all of it at once.
  double erosion = std::numeric_limits<double>::infinity();
};

// Takes from a volume what a head goes through, and returns what it was. A voxel counts by the share of it that is
// below the surface, which is exact on average over flat surfaces of any direction. Nothing happens where the way is
// not finite, or longer than kMostDrillWay times the diameter. On all threads of the arena; O(voxels of the head's
// surface).
DrillCut drill(SparseVolume& volume, const DrillBit& tool, const DrillMove& move);

// The cubes of `edge` voxels, whole blocks, that drill() reads and changes on a move, as far as they meet a box, in
// voxels; by their numbers along the axes. Empty where nothing happens.
std::vector<VoxelIndex> cubesOfMove(const SparseVolume& grid, const Box& within, int edge, const DrillBit& tool,
                                    const DrillMove& move);

// How far a head may go in one call, in its diameters.
inline constexpr double kMostDrillWay = 4.0;

// The material of a volume as drill() counts it, mm³. O(blocks).
double countedMaterial(const SparseVolume& volume);

}  // namespace handwheel
