// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

#include <string_view>

namespace handwheel {

// Plans with a planner of OMPL (the Open Motion Planning Library, 1.5). Its motions are checked by MotionCheck and its
// states by distances, so that its paths are free between their points, as those of planBySbl() are. planner:
// "rrtconnect", "ompl-prm", "lazyprm", "ompl-sbl", "bitrrt", "bkpiece" or "est". The settings neighbourhood and
// mostMilestones are ignored: OMPL chooses its own. The seed makes a plan reproducible if only one runs at a time,
// except for "ompl-prm", for which OMPL searches in a thread of its own.
PlanResult planByOmpl(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                      const PlanSettings& settings, std::string_view planner, Progress progress = {});

}  // namespace handwheel
