// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/finish/SurfaceFinish.h"
#include "machining/measure/ProfileMeasure.h"

#include <optional>
#include <vector>

namespace handwheel {

// The roughness Ra of a range, by the geometry of feed and nose alone, µm. A sixth of the range, 16 %, may be rougher
// than what is read: the rule of ISO 4288 for a limit on the drawing.
struct FinishReading {
  double roughness = 0.0, largest = 0.0;
  double largestAt = 0.0;  // mm, height
};

// None where a sample of the range is not known, or the range has none.
std::optional<FinishReading> readFinish(const SurfaceFinish& finish, const TurnedProfile& profile, TurningSide side,
                                        AxisRange range);

// A stretch that one pass has left.
struct FinishInterval {
  double from = 0.0, to = 0.0;  // mm, heights of its first and last sample
  std::uint32_t pass = FinishMark::kNoPass;
  double feed = 0.0;      // mm per revolution, the largest
  FinishReading reading;  // of all its samples
};

// The stretches of a side whose finish is known, by height. Where there is no material, or in the bore no bore, there
// are none. O(samples).
std::vector<FinishInterval> finishIntervals(const SurfaceFinish& finish, const TurnedProfile& profile,
                                            TurningSide side);

}  // namespace handwheel
