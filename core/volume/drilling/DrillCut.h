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
  // Unit vector in which the head pushes the removed material (He 2008, equation A-8); zero: nothing was removed.
  Vec3 push = Vec3::Zero();
  std::vector<VoxelIndex> changedBlocks;  // in an order that depends only on the arguments
};

// A straight move of a drill head.
struct DrillMove {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();  // positions of the centre, mm
  Vec3 axis = Vec3::UnitZ();                    // unit vector towards the shank
  // Factor η of He 2008, equation 3-21, at least 1: the largest loss of a voxel in the head, in lengths of the move.
  // With less, material would remain in the head of an advancing drill. Infinite: the whole voxel is removed at once.
  double erosion = std::numeric_limits<double>::infinity();
};

// Removes the material that a head sweeps, and returns it. A voxel counts by its fraction below the surface, which is
// exact on average for flat surfaces of any direction. Nothing happens if the move is not finite, or longer than
// kMostDrillTravel times the diameter. Runs on all threads of the arena; O(voxels of the head's surface).
DrillCut drill(SparseVolume& volume, const DrillBit& tool, const DrillMove& move);

// Returns the indices of the cubes that drill() reads and changes on a move, restricted to those that intersect a box,
// in voxels. edge: edge length of the cubes, in voxels, a multiple of that of a block. The result is empty if drill()
// would do nothing.
std::vector<VoxelIndex> cubesOfMove(const SparseVolume& grid, const Box& within, int edge, const DrillBit& tool,
                                    const DrillMove& move);

// Largest length of a move in one call, in diameters of the head.
inline constexpr double kMostDrillTravel = 4.0;

// Returns the volume of the material by the counting of drill(), mm³. O(blocks).
double countedMaterial(const SparseVolume& volume);

}  // namespace handwheel
