// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "volume/SparseVolume.h"

namespace handwheel {

// Offsets of volumes by distances of any length. Distances are measured exactly, to the surface that surfaceOf()
// returns. They are evaluated near the new surface only, block by block from coarse to fine, so that neither memory nor
// time grows with the distance. An outward offset rounds convex edges, which an inward one keeps sharp. Results may be
// empty. All lengths are in mm. The functions use all threads of the arena, and take O(b log n) for b blocks near the
// surfaces and n triangles.
//
// Errors: ValueOutOfRange (for a distance), VolumeErrors::TooFine (too many voxels along an axis), TooLarge (for the
// memory that is left); Cancelled.

// Offsets the surface of a volume outwards, or inwards if the distance is negative.
Result<SparseVolume> movedSurface(const SparseVolume& volume, double distance, Progress progress = {});

// The position of a shell's wall: within the material, around it, or half on either side.
enum class WallSide { Inside, Outside, Middle };
// Returns the wall along the surface. Additional error: VolumeErrors::WallTooThin for less than two voxels.
Result<SparseVolume> shellOf(const SparseVolume& volume, double wall, WallSide side, Progress progress = {});

// Returns the least number of bytes that these functions need, in addition to a volume with this number of blocks.
double predictedOffsetBytes(double blocks);

// Morphological closing: fills gaps, cracks, holes and pits that a ball of this radius cannot enter. Only adds
// material.
Result<SparseVolume> withoutGaps(const SparseVolume& volume, double radius, Progress progress = {});
// Morphological opening: removes walls, bridges, spikes and sharp edges that cannot contain such a ball. Only removes
// material.
Result<SparseVolume> withoutThinParts(const SparseVolume& volume, double radius, Progress progress = {});

}  // namespace handwheel
