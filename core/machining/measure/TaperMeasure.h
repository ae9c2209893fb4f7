// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/measure/ProfileMeasure.h"

namespace handwheel {

// A straight line fitted to a profile.
struct TaperReading {
  double angle = 0.0;      // radian, between the axis and the side; positive where the radius grows upwards
  double deviation = 0.0;  // mm, the largest distance of a sample from the line, in r
  AxisRange range;         // from the first to the last sample used
  double radius = 0.0;     // mm, radius of the line in the middle of the range
};

// Returns the taper of the samples of a range, by least squares in r. Samples beyond the ends of the taper are left
// out: those without material, those behind a face, and neighbours of a clearly different slope, like the cylinder
// beside a chamfer. Of several tapers, the one with the largest change of radius is returned. Returns nothing with
// fewer than 2 samples.
std::optional<TaperReading> measureTaper(const TurnedProfile& profile, TurningSide side, AxisRange range);

}  // namespace handwheel
