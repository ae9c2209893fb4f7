// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPasses.h"
#include "machining/lathe/LatheCollisions.h"

#include <vector>

namespace handwheel {

// Largest distance between a crash and the path of its pass, mm. On the manual lathe the crash is beside the path,
// because the step that would crash is not made.
inline constexpr double kCrashReach = 1.0;

// Returns the times (s) of the crashes of a part on the clock of its passes. This clock, which replays and reports use,
// starts with the first pass and leaves out the pauses between passes; it is not the clock of the machine. If the exact
// time of a crash is not known, the result is the end of the pass that was being cut; if that pass is not known either,
// the end of all passes. O(passes + crashes · points of a pass).
std::vector<double> crashSeconds(const TurningPasses& passes, const std::vector<LatheCollision>& crashes);

}  // namespace handwheel
