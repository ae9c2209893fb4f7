// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/planners/Planners.h"

#include "base/Translatable.h"
#include "planning/planners/OmplPlanner.h"
#include "planning/planners/Roadmap.h"
#include "planning/planners/SblPlanner.h"

#include <algorithm>
#include <cassert>

namespace handwheel {

std::span<const PlannerName> planners() {
  static constexpr PlannerName kAll[] = {{"sbl", translatable("Property", "SBL")},
                                         {"prm", translatable("Property", "PRM, kept for the cell")},
                                         {"rrtconnect", translatable("Property", "RRTConnect (OMPL)")},
                                         {"ompl-prm", translatable("Property", "PRM (OMPL)")},
                                         {"lazyprm", translatable("Property", "Lazy PRM (OMPL)")},
                                         {"ompl-sbl", translatable("Property", "SBL (OMPL)")},
                                         {"bitrrt", translatable("Property", "BiTRRT (OMPL)")},
                                         {"bkpiece", translatable("Property", "BKPIECE (OMPL)")},
                                         {"est", translatable("Property", "EST (OMPL)")}};
  return kAll;
}

PlanResult planPath(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                    const PlanSettings& settings, std::string_view planner, Progress progress) {
  assert(std::ranges::any_of(planners(), [&](const PlannerName& each) { return each.id == planner; }));
  if (planner == "sbl") return planBySbl(scene, start, goal, settings, progress);
  if (planner == "prm") {
    Roadmap once;
    return (settings.roadmap ? *settings.roadmap : once).plan(scene, start, goal, settings, progress);
  }
  return planByOmpl(scene, start, goal, settings, planner, progress);
}

}  // namespace handwheel
