// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/measure/ProfileMeasure.h"
#include "machining/thread/PartThreads.h"

namespace handwheel {

// The measurements of a thread, mm.
struct ThreadReading {
  double pitch = 0.0;               // mean distance of neighbouring grooves along the axis
  double largestError = 0.0;        // largest deviation of one of these distances
  double major = 0.0, minor = 0.0;  // diameters of crest and root; in a bore, of root and crest
  double pitchDiameter = 0.0;       // diameter at which the groove is as wide as half the pitch
  int grooves = 0;
};

// Measures the thread of a side along a line on the surface, parallel to the axis. Returns nothing if the range has
// fewer than two grooves. The error is below a thousandth of the pitch. O(range / pitch).
std::optional<ThreadReading> measureThread(const TurnedProfile& profile, const PartThreads& threads, TurningSide side,
                                           AxisRange range);

}  // namespace handwheel
