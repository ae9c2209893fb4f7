// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PathCheck.h"

namespace handwheel {

// Returns the reasons why a path whose motions are free is not proven. These are corners that its controller rounds
// where not everything within the triangle of the corner is free, and the first waypoint with a line that may grip or
// release something. The triangle lies between the ends of both motions: in joint space for joint motions, in space for
// lines, and in both for a corner between these. clearance: mm.
std::vector<ProofGap> gapsOf(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                             const ResolvedPath& resolvedPath, double clearance, const Progress& progress);

}  // namespace handwheel
