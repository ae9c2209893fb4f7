// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Container.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// Writes a robot cell to a container. It holds all that the cell needs: the description in the blob "cell/robot.urdf",
// and of each mesh the points (three floats each, mm) and triangles (three indices each) in "cell/surfaces/NNNN/…". The
// manifest has the value of each joint by its name; rad, mm. The bodies are stored as in writeBodies().
void writeCell(const RobotCellSnapshot& cell, Container& container);

// Reads a robot cell from a container. Missing and invalid parts are left out, and the joints are brought within their
// limits. shapeSides: number of sides of round shapes, as in surfaceOf(). Errors: EntryMissing {cell/robot.urdf}, those
// of readUrdf(), Cancelled.
Result<SnapshotPointer> readCell(const Container& container, std::uint32_t shapeSides, std::vector<Error>& damage,
                                 Progress progress);

}  // namespace handwheel
