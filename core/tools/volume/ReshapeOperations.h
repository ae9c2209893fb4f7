// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Operation.h"
#include "volume/SparseVolume.h"
#include "volume/VolumeParts.h"

namespace handwheel {

// Returns the operation that leaves a wall along a volume's surface. Its parameters are the thickness and the side.
const Operation& shellOperation();
// Returns the operation that moves the surface of a volume outwards or inwards.
const Operation& offsetOperation();
// Returns the operation that unites two volumes, subtracts one from the other, or intersects them.
const Operation& booleanOperation();
// Returns the operation that removes parts smaller than a ball with a given diameter. The largest part always remains.
const Operation& debrisOperation();
// Returns the operation that fills gaps that a ball with a given radius cannot enter.
const Operation& gapsOperation();
// Returns the operation that smooths small bumps and dents of the whole surface.
const Operation& smoothOperation();

// Converts the number of voxels of a ball, rounded to an integer, to its diameter in mm, and vice versa.
double diameterOf(std::uint64_t voxels, double voxel);
std::uint64_t voxelsOf(double diameter, double voxel);

// Returns the number of parts that remain with the values of debrisOperation().
std::size_t keptParts(const VolumeParts& parts, const OperationValues& values, double voxel);

// Returns the volume after an operation. Errors: Cancelled, VolumeErrors::NothingLeft; the errors of shellOf(),
// movedSurface(), combined() and withoutGaps().
Result<SparseVolume> makeShell(const SparseVolume& volume, const OperationValues& values, Progress progress);
Result<SparseVolume> makeOffset(const SparseVolume& volume, const OperationValues& values, Progress progress);
Result<SparseVolume> makeBoolean(const SparseVolume& volume, const SparseVolume& other, const OperationValues& values,
                                 Progress progress);
Result<SparseVolume> removeDebris(const SparseVolume& volume, const OperationValues& values, Progress progress);
Result<SparseVolume> closeGaps(const SparseVolume& volume, const OperationValues& values, Progress progress);
Result<SparseVolume> smoothWhole(const SparseVolume& volume, const OperationValues& values, Progress progress);

}  // namespace handwheel
