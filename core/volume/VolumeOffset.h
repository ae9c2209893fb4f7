// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "volume/SparseVolume.h"

namespace handwheel {

// Volumes whose surface is that of another, moved by distances of any length. Distances are exact to the surface that
// surfaceOf() gives: they are asked for where the new surface is, block by block from coarse to fine, so that neither
// memory nor time grow with what lies between. What grows is rounded at its edges, and what shrinks keeps them. May be
// empty. All in mm, on all threads of the arena; O(blocks of the surfaces, log n each).
//
// Errors: ValueOutOfRange (of a distance), VolumeErrors::TooFine (too many voxels along an axis), TooLarge (for the
// memory that is left); Cancelled.

// Offsets the surface of a volume outwards; inwards with a distance below 0.
Result<SparseVolume> movedSurface(const SparseVolume& volume, double distance, Progress progress = {});

// Where the wall of a shell is: within the material, around it, or half and half.
enum class WallSide { Inside, Outside, Middle };
// The wall along the surface alone. Error besides: VolumeErrors::WallTooThin for less than two voxels.
Result<SparseVolume> shellOf(const SparseVolume& volume, double wall, WallSide side, Progress progress = {});

// What they ask the system for beside a volume of so many blocks, at least; bytes.
double predictedOffsetBytes(double blocks);

// Morphological closing: gaps, cracks, holes and pits that a ball of this radius does not get into are filled. Adds
// only.
Result<SparseVolume> withoutGaps(const SparseVolume& volume, double radius, Progress progress = {});
// Opening: walls, bridges and spikes that do not hold such a ball go, and so do sharp edges. Takes only.
Result<SparseVolume> withoutThinParts(const SparseVolume& volume, double radius, Progress progress = {});

}  // namespace handwheel
