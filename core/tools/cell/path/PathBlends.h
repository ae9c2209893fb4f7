// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PathCheck.h"

namespace handwheel {

// Returns the collision-free blend radius of each waypoint of a path, mm. It is at most the wanted radius, and half of
// the shorter motion beside the waypoint; 0: an exact stop. Free is all that is within the triangle of the corner,
// which is the waypoint and the ends of its zone: in joint space between joint motions, and of the tool's pose beside a
// line. A controller rounds a corner within it. A zone ends where the tool leaves the ball of its radius about the
// waypoint. After a cancellation the remaining waypoints are exact stops. reduced: receives the waypoints whose radius
// is smaller because not everything is free; may be null.
std::vector<double> certifiedBlends(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const ResolvedPath& resolvedPath, double clearance, const Progress& progress = {},
                                    std::vector<std::size_t>* reduced = nullptr);

}  // namespace handwheel
