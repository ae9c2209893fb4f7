// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/path/PathCheck.h"

namespace handwheel {

// The collision-free blend of each place of a path, mm. At most the wanted one; 0: an exact stop. At most the wanted
// one; 0: an exact stop. Within a zone each joint may be anywhere between where the two motions have it there, half as
// far again where lines bend in joint space: everything is that far from the robot. What a controller does in a zone is
// not known but that it stays there. Exact stops at the rest once cancelled.
std::vector<double> certifiedBlends(const CellScene& scene, const CellPlans& plans, const RobotPath& path,
                                    const ResolvedPath& way, double clearance, const Progress& progress = {});

}  // namespace handwheel
