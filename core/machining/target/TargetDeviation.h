// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/TurnedProfile.h"
#include "machining/measure/ProfileMeasure.h"
#include "machining/target/TargetProfile.h"

#include <limits>
#include <vector>

namespace handwheel {

// The distance (mm) of the surface of a turned part from its target. It is positive where material is left, and
// negative where too much was cut.
struct TargetDeviation {
  struct Extreme {
    double distance = 0.0;
    ProfilePoint at{0, 0};  // position on the part, z in the target's coordinates
  };
  // Deviations of the outer and the inner surface at each sample of the part. An inner one is NaN if there is no bore,
  // an outer one if neither part nor target has material, and both are NaN outside of the measured range.
  std::vector<double> outer, inner;
  // The largest deviations in either direction, including those of flat ends and missing bores; 0: none.
  Extreme largestOver, largestUnder;

  double largest() const { return std::max(largestOver.distance, -largestUnder.distance); }
};

// The whole part, of any length.
inline constexpr AxisRange kWholeAxis{-std::numeric_limits<double>::infinity(),
                                      std::numeric_limits<double>::infinity()};

// Returns the range of a part to be compared with its target. It begins one sample above the lower end of the target:
// the material below, which the chuck holds, is parted off, and the sample beside the step at that end is not
// meaningful. Material beyond the upper end is included, because it has to be removed. base: as for deviationFrom();
// from: earliest start of the range, mm above the lower end of the part.
AxisRange rangeOfTarget(const TargetProfile& target, const TurnedProfile& part, double base,
                        double from = kWholeAxis.from);

// Measures the deviations of a part from its target. base: mm, z of the lower end of the part in the target's
// coordinates; range: measured range, mm above the lower end of the part. The outside of the part is measured from the
// outside of the target, and its bore from the bores, even if the other side of a thin wall is nearer. If the target
// cannot be split into sides (sidesOf()), everything is measured from the nearest surface. A bore that should not exist
// counts as too much cut, by its radius. The result is incomplete if cancelled. O(samples · log segments).
TargetDeviation deviationFrom(const TargetProfile& target, const TurnedProfile& part, double base,
                              Progress progress = {}, AxisRange range = kWholeAxis);

}  // namespace handwheel
