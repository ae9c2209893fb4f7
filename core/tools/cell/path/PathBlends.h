// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PathCheck.h"

namespace handwheel {

// Returns the collision-free blend radius of each waypoint of a path, mm. At most the wanted one; 0: an exact stop.
// Within a zone each joint may be anywhere between its values on the two motions there, half as far again if lines bend
// in joint space: all obstacles are farther from the robot than that. The motion of a controller within a zone is
// unknown, except that it stays inside. After a cancel, exact stops at the remaining waypoints.
std::vector<double> certifiedBlends(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const ResolvedPath& resolvedPath, double clearance, const Progress& progress = {});

}  // namespace handwheel
