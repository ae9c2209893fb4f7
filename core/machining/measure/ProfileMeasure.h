// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"

#include <optional>
#include <vector>

namespace handwheel {

// A part of the axis, mm above the lower end of the part.
struct AxisRange {
  double from = 0.0, to = 0.0;
};

// What a micrometer finds along a range. Diameters, mm.
struct DiameterReading {
  double least = 0.0, largest = 0.0, mean = 0.0;
  double leastAt = 0.0, largestAt = 0.0;  // mm, height
};

// A circle fitted to a profile.
struct ArcReading {
  double radius = 0.0;        // mm
  ProfilePoint centre{0, 0};  // (r, z)
  double deviation = 0.0;     // mm, the largest distance of a sample from the circle
};

// The diameters of all samples in the range; of the bore, too. None where the range has no sample, where the part has
// no material at one of them, or where one is not bored. O(samples in the range).
std::optional<DiameterReading> measureDiameter(const TurnedProfile& profile, TurningSide side, AxisRange range);

// The height at which a face crosses the radius (mm), nearest to `near` and not further than `reach` from it; the ends
// of the part count as faces. Where several faces are as near, the lower one. None where there is no face.
std::optional<double> measureFace(const TurnedProfile& profile, TurningSide side, double radius, double near,
                                  double reach);

// The circle nearest to the samples of a range, by least squares of the distances. None with fewer than 5 samples, or
// where they lie on a line.
std::optional<ArcReading> measureArc(const TurnedProfile& profile, TurningSide side, AxisRange range);

}  // namespace handwheel
