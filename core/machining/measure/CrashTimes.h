// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPasses.h"
#include "machining/lathe/LatheCollisions.h"

#include <vector>

namespace handwheel {

// How far a crash of the manual lathe is from its path at most, mm. The step that would crash is not made.
inline constexpr double kCrashReach = 1.0;

// When the crashes of a part were, on the clock of its passes. That is s since the begin of the first one, pauses
// between passes left out, as replays and reports count. The clock of the machine is another one. Where it is not known
// exactly, the end of the pass that was under way; where that is not known, the end of all. O(passes + crashes · points
// of a pass).
std::vector<double> crashSeconds(const TurningPasses& passes, const std::vector<LatheCollision>& crashes);

}  // namespace handwheel
