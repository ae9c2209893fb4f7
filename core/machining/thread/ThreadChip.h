// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/thread/PartThreads.h"

namespace handwheel {

// The chip of a thread pass in a section along the axis, between two turns.
struct TurnChip {
  double area = 0.0;   // mm²
  double width = 0.0;  // mm, length of the edge that cuts
};

// Returns the chip of a groove beyond the grooves before it, by the midpoint rule. before: may be null; middle: its
// height, mm; surface: mm, radius of the part there. O(grooves).
TurnChip chipOf(const ThreadGroove& groove, const PartThreads* before, double middle, double surface);

}  // namespace handwheel
