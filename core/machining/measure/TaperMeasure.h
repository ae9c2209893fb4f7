// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/measure/ProfileMeasure.h"

namespace handwheel {

// A straight line fitted to a profile.
struct TaperReading {
  double angle = 0.0;      // rad, angle between the axis and the side; positive if the radius grows upwards
  double deviation = 0.0;  // mm, the largest distance of a sample from the line, in r
  AxisRange range;         // heights of the first and the last sample that were used
  double radius = 0.0;     // mm, radius of the line in the middle of the range
};

// Returns the taper of the samples of a range, by least squares in r. Samples beyond the ends of the taper are left
// out. These are samples without material, samples beyond a face, and neighbours with a clearly different slope, such
// as the cylinder beside a chamfer. Of several tapers, the one with the largest change of radius is returned. Returns
// nothing if there are fewer than 2 samples.
std::optional<TaperReading> measureTaper(const TurnedProfile& profile, TurningSide side, AxisRange range);

}  // namespace handwheel
