// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

#include <string_view>

namespace handwheel {

// Plans with a planner of OMPL (the Open Motion Planning Library, 1.5). Motions are checked by MotionCheck and single
// configurations by distance queries, so that the path is free at all points, like that of planBySbl(). planner:
// "rrtconnect", "ompl-prm", "lazyprm", "ompl-sbl", "bitrrt", "bkpiece" or "est". The settings neighbourhood and
// mostMilestones are ignored, because OMPL chooses its own values. Plans with the same seed are equal if only one plan
// runs at a time, except for "ompl-prm", for which OMPL searches on a thread of its own.
PlanResult planByOmpl(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                      const PlanSettings& settings, std::string_view planner, Progress progress = {});

}  // namespace handwheel
