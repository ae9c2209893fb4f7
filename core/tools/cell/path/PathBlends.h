// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PathCheck.h"

namespace handwheel {

// Returns the collision-free blend radius of each waypoint of a path, mm. It is at most the wanted radius; 0: an exact
// stop. The motion of a controller within a blend zone is unknown, except that the tool stays inside. Each joint may
// deviate from its value at the waypoint by the sum of its deviations on the two motions in the zone, times 1.5 if one
// of these motions is a straight line of the tool, which is curved in joint space; the robot must keep the clearance at
// all these joint values. After a cancellation the remaining waypoints are exact stops.
std::vector<double> certifiedBlends(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const ResolvedPath& resolvedPath, double clearance, const Progress& progress = {});

}  // namespace handwheel
