// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"

#include <vector>

namespace handwheel {

// The area of the plane that closed curves go around a number of times that is not zero: what several of them cover
// counts once, and a hollow, which runs the other way round, not at all. Curves may cross, touch and coincide, each
// other and themselves. Exact but for rounding: strips between the heights of all corners and crossings are cut into
// trapezoids. O(n · (log n + m)) for n edges of which m cross one height. Of no use once cancelled.
double coveredArea(const std::vector<std::vector<Eigen::Vector2d>>& curves, Progress progress = {});

}  // namespace handwheel
