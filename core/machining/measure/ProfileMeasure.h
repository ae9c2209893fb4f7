// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"

#include <optional>
#include <vector>

namespace handwheel {

// An interval of the axis. Its limits are in mm above the lower end of the part.
struct AxisRange {
  double from = 0.0, to = 0.0;
};

// The reading of a micrometer along a range. Diameters are in mm.
struct DiameterReading {
  double least = 0.0, largest = 0.0, mean = 0.0;
  double leastAt = 0.0, largestAt = 0.0;  // mm, heights of the least and the largest diameter
};

// A circle fitted to a profile.
struct ArcReading {
  double radius = 0.0;        // mm
  ProfilePoint centre{0, 0};  // (r, z)
  double deviation = 0.0;     // mm, the largest distance of a sample from the circle
};

// Returns the diameters of the samples in a range, on the outside or in the bore. Returns nothing if the range has no
// sample, or if one of its samples has no material or, for the bore, is not bored. O(samples in the range).
std::optional<DiameterReading> measureDiameter(const TurnedProfile& profile, TurningSide side, AxisRange range);

// Returns the height of the face that crosses a radius (mm), nearest to the height `near` and not further than `reach`
// from it, in the exact section of the part. The ends of the part count as faces. Of two faces at the same distance,
// the lower one is returned. Returns nothing if there is no such face.
std::optional<double> measureFace(const TurnedProfile& profile, TurningSide side, double radius, double near,
                                  double reach);

// Returns the circle nearest to the samples of a range, by least squares of the distances. Returns nothing if the range
// has fewer than 5 samples, or if they lie on a line.
std::optional<ArcReading> measureArc(const TurnedProfile& profile, TurningSide side, AxisRange range);

}  // namespace handwheel
