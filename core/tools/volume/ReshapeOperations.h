// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Operation.h"
#include "volume/SparseVolume.h"
#include "volume/VolumeParts.h"

namespace handwheel {

// Leaves a wall along the surface of a volume, with a thickness and a side.
const Operation& shellOperation();
// Moves the surface of a volume outwards or inwards.
const Operation& offsetOperation();
// Unites a volume with another, subtracts it, or intersects them.
const Operation& booleanOperation();
// Removes parts that are smaller than a ball of a diameter; the largest part stays.
const Operation& debrisOperation();
// Fills gaps that a ball of a radius cannot enter.
const Operation& gapsOperation();
// Smooths small bumps and dents of the whole surface.
const Operation& smoothOperation();

// Converts between the number of voxels of a ball, rounded to an integer, and its diameter, mm.
double diameterOf(std::uint64_t voxels, double voxel);
std::uint64_t voxelsOf(double diameter, double voxel);

// Returns the number of parts that stay, by the values of debrisOperation().
std::size_t keptParts(const VolumeParts& parts, const OperationValues& values, double voxel);

// Returns the volume after one of these operations. Errors: Cancelled, VolumeErrors::NothingLeft; those of shellOf(),
// movedSurface(), combined() and withoutGaps().
Result<SparseVolume> makeShell(const SparseVolume& volume, const OperationValues& values, Progress progress);
Result<SparseVolume> makeOffset(const SparseVolume& volume, const OperationValues& values, Progress progress);
Result<SparseVolume> makeBoolean(const SparseVolume& volume, const SparseVolume& other, const OperationValues& values,
                                 Progress progress);
Result<SparseVolume> removeDebris(const SparseVolume& volume, const OperationValues& values, Progress progress);
Result<SparseVolume> closeGaps(const SparseVolume& volume, const OperationValues& values, Progress progress);
Result<SparseVolume> smoothWhole(const SparseVolume& volume, const OperationValues& values, Progress progress);

}  // namespace handwheel
