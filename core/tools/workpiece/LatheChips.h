// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "machining/lathe/CutMeter.h"

#include <vector>

namespace handwheel {

// Returns the chip of a cut as a curled line, for display. It goes from the tip outward and up over the rake, tighter
// for a thin chip and with more coils for a wide one, and runs with the work. Empty if nothing is cut. tip: mm, in the
// scene; turns: spindle revolutions. O(1).
std::vector<std::vector<Vec3>> chipCurl(const LatheLoad& load, const Vec3& tip, double turns);

}  // namespace handwheel
