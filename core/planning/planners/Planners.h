// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

#include <span>
#include <string_view>

namespace handwheel {

// The names of a planner.
struct PlannerName {
  const char* id;     // name on the command line: "sbl"
  const char* title;  // English, translated for display (context "Property")
};

// Returns all planners, with the planners of Handwheel before those of OMPL.
std::span<const PlannerName> planners();

// Plans with the planner of this id, which must exist. Every planner returns a path that is free at all points.
PlanResult planPath(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                    const PlanSettings& settings, std::string_view planner, Progress progress = {});

}  // namespace handwheel
