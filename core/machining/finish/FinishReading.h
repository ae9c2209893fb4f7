// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/finish/SurfaceFinish.h"
#include "machining/measure/ProfileMeasure.h"

#include <optional>
#include <vector>

namespace handwheel {

// The roughness Ra of a range, by the geometry of feed and nose alone, µm. A sixth of the samples, 16 %, may be rougher
// than the value: the rule of ISO 4288 for a limit on the drawing.
struct FinishReading {
  double roughness = 0.0, largest = 0.0;
  double largestAt = 0.0;  // mm, height of the largest
};

// Returns nothing if the finish of a sample of the range is not known, or the range has no sample.
std::optional<FinishReading> readFinish(const SurfaceFinish& finish, const TurnedProfile& profile, TurningSide side,
                                        AxisRange range);

// An interval that one pass has left.
struct FinishInterval {
  double from = 0.0, to = 0.0;  // mm, heights of its first and last sample
  std::uint32_t pass = FinishMark::kNoPass;
  double feed = 0.0;      // mm per revolution, the largest
  FinishReading reading;  // reading of all its samples
};

// Returns the intervals of a side whose finish is known, by height. Heights without material, or without a bore if the
// bore is asked for, have none. O(samples).
std::vector<FinishInterval> finishIntervals(const SurfaceFinish& finish, const TurnedProfile& profile,
                                            TurningSide side);

}  // namespace handwheel
