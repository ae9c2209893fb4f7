// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Progress.h"

#include <vector>

namespace handwheel {

// Computes the plane area that closed curves enclose, by nonzero winding number. Overlapping areas count once; hollows,
// which have the opposite orientation, do not count. Curves may cross, touch or coincide with each other and with
// themselves. The result is exact except for rounding: the strips between the heights of all corners and crossings are
// cut into trapezoids. O(n · (log n + m)) for n edges, of which at most m cross one height. The result is invalid if
// cancelled.
double coveredArea(const std::vector<std::vector<Eigen::Vector2d>>& curves, Progress progress = {});

}  // namespace handwheel
