// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPasses.h"
#include "machining/lathe/LatheCollisions.h"

#include <vector>

namespace handwheel {

// Largest distance of a crash of the manual lathe from its path, mm. The step that would crash is not made.
inline constexpr double kCrashReach = 1.0;

// Returns the times of the crashes of a part on the clock of its passes. That is s since the begin of the first pass,
// without the pauses between passes, as replays and reports count. The clock of the machine is another one. If the time
// is not known exactly, it is the end of the pass that was under way; if that is not known, the end of all. O(passes +
// crashes · points of a pass).
std::vector<double> crashSeconds(const TurningPasses& passes, const std::vector<LatheCollision>& crashes);

}  // namespace handwheel
