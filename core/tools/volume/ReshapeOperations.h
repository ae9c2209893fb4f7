// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Operation.h"
#include "volume/SparseVolume.h"
#include "volume/VolumeParts.h"

namespace handwheel {

// Leaves a wall along the surface of a volume: its thickness, and on which side.
const Operation& shellOperation();
// Moves the surface of a volume out or in.
const Operation& offsetOperation();
// Unites a volume with another, or takes what is in it, or what is not.
const Operation& booleanOperation();
// Takes parts away that are smaller than a ball of a diameter; the largest part stays.
const Operation& debrisOperation();
// Fills what a ball of a radius does not get into.
const Operation& gapsOperation();
// Takes small bumps and dents off the whole surface.
const Operation& smoothOperation();

// The diameter of a ball of so many voxels, mm, and the voxels of a ball of this diameter, to the next whole one.
double diameterOf(std::uint64_t voxels, double voxel);
std::uint64_t voxelsOf(double diameter, double voxel);

// How many of the parts stay, by the values of debrisOperation().
std::size_t keptParts(const VolumeParts& parts, const OperationValues& values, double voxel);

// The volume after one of these. Errors: Cancelled, VolumeErrors::NothingLeft; those of shellOf(), movedSurface(),
// combined() and withoutGaps().
Result<SparseVolume> makeShell(const SparseVolume& volume, const OperationValues& values, Progress progress);
Result<SparseVolume> makeOffset(const SparseVolume& volume, const OperationValues& values, Progress progress);
Result<SparseVolume> makeBoolean(const SparseVolume& volume, const SparseVolume& other, const OperationValues& values,
                                 Progress progress);
Result<SparseVolume> removeDebris(const SparseVolume& volume, const OperationValues& values, Progress progress);
Result<SparseVolume> closeGaps(const SparseVolume& volume, const OperationValues& values, Progress progress);
Result<SparseVolume> smoothWhole(const SparseVolume& volume, const OperationValues& values, Progress progress);

}  // namespace handwheel
