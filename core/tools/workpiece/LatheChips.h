// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "machining/lathe/CutMeter.h"

#include <vector>

namespace handwheel {

// Returns the chip of a cut as a curled line, for display. The line goes from the tip outward and up over the rake
// face, and moves with the work. A thin chip is curled more tightly, and a wide chip has more coils. The result is
// empty if nothing is cut. tip: the position of the tip in the scene, mm; turns: the revolutions of the spindle. O(1).
std::vector<std::vector<Vec3>> chipCurl(const LatheLoad& load, const Vec3& tip, double turns);

}  // namespace handwheel
