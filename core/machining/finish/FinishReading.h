// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/finish/SurfaceFinish.h"
#include "machining/measure/ProfileMeasure.h"

#include <optional>
#include <vector>

namespace handwheel {

// The roughness Ra of a range, µm. It follows from the geometry of feed and nose alone. By the rule of ISO 4288 for a
// limit on the drawing, 16 % of the samples may be rougher than `roughness`.
struct FinishReading {
  double roughness = 0.0, largest = 0.0;
  double largestAt = 0.0;  // mm, height of the largest roughness
};

// Returns the roughness of a side along a range. Returns nothing if the finish of a sample of the range is not known,
// or the range has no sample.
std::optional<FinishReading> readFinish(const SurfaceFinish& finish, const TurnedProfile& profile, TurningSide side,
                                        AxisRange range);

// An interval of the surface that one pass has left.
struct FinishInterval {
  double from = 0.0, to = 0.0;  // mm, heights of its first and last sample
  std::uint32_t pass = FinishMark::kNoPass;
  double feed = 0.0;      // mm per revolution, largest feed
  FinishReading reading;  // reading of all its samples
};

// Returns the intervals of a side whose finish is known, in ascending order of height. Heights without material belong
// to no interval, and neither do heights without a bore if the bore is asked for. O(samples).
std::vector<FinishInterval> finishIntervals(const SurfaceFinish& finish, const TurnedProfile& profile,
                                            TurningSide side);

}  // namespace handwheel
