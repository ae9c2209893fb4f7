// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "planning/Plan.h"

#include <span>
#include <string_view>

namespace handwheel {

// A planner that can be chosen.
struct PlannerName {
  const char* id;     // on the command line: "sbl"
  const char* title;  // English, context "Property"
};

// Returns all planners, our own first.
std::span<const PlannerName> planners();

// Plans with the planner of this id, which must exist. The path is free between its points with any planner.
PlanResult planPath(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                    const PlanSettings& settings, std::string_view planner, Progress progress = {});

}  // namespace handwheel
