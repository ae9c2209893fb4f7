// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Operation.h"
#include "volume/SparseVolume.h"

namespace handwheel {

// Leaves a wall along the surface of a volume: its thickness, and on which side.
const Operation& shellOperation();
// Moves the surface of a volume out or in.
const Operation& offsetOperation();

// The volume after one of these. Errors: those of shellOf() and movedSurface(); VolumeErrors::NothingLeft.
Result<SparseVolume> makeShell(const SparseVolume& volume, const OperationValues& values, Progress progress);
Result<SparseVolume> makeOffset(const SparseVolume& volume, const OperationValues& values, Progress progress);

}  // namespace handwheel
