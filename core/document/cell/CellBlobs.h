// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Container.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// Writes a robot cell to a container, with all that the cell needs. The blob "cell/robot.urdf" contains the
// description, the blobs "cell/surfaces/NNNN/…" the points (three floats each, mm) and triangles (three indices each)
// of the meshes. The manifest contains the joint values by the names of the joints; rad, mm. writeBodies() writes the
// bodies.
void writeCell(const RobotCellSnapshot& cell, Container& container);

// Reads a robot cell from a container. Missing and invalid parts are omitted and added to damage, and joint values are
// brought within their limits. shapeSides: number of sides of round shapes, as in surfaceOf(). Errors: EntryMissing
// {cell/robot.urdf}, the errors of readUrdf(), Cancelled.
Result<SnapshotPointer> readCell(const Container& container, std::uint32_t shapeSides, std::vector<Error>& damage,
                                 Progress progress);

}  // namespace handwheel
