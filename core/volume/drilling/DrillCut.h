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
  double removed = 0.0;  // mm³
  Vec3 push =
      Vec3::Zero();  // unit vector in which the head pushes the removed material, by A-8; 0: nothing was removed
  std::vector<VoxelIndex> changedBlocks;  // in an order that depends on the arguments alone
};

// A straight move of a drill head.
struct DrillMove {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // positions of the centre, mm
  Vec3 axis = Vec3::UnitZ();                    // unit vector to the shank
  // η of (3-21): the largest loss of a voxel in the head, in lengths of the move. At least 1; with less, material would
  // stay in the head of an advancing drill. Infinite: the whole voxel at once.
  double erosion = std::numeric_limits<double>::infinity();
};

// Removes the material that a head sweeps, and returns what was removed. A voxel counts by its fraction below the
// surface, which is exact on average for flat surfaces of any direction. Nothing happens if the move is not finite, or
// longer than kMostDrillTravel times the diameter. On all threads of the arena; O(voxels of the head's surface).
DrillCut drill(SparseVolume& volume, const DrillBit& tool, const DrillMove& move);

// Returns the indices of the cubes that drill() reads and changes on a move, as far as they intersect a box, in voxels.
// edge: their edge length, in voxels, a multiple of a block. Empty if nothing happens.
std::vector<VoxelIndex> cubesOfMove(const SparseVolume& grid, const Box& within, int edge, const DrillBit& tool,
                                    const DrillMove& move);

// Longest move of a head in one call, in its diameters.
inline constexpr double kMostDrillTravel = 4.0;

// Returns the volume of the material as drill() counts it, mm³. O(blocks).
double countedMaterial(const SparseVolume& volume);

}  // namespace handwheel
