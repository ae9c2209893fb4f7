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

// The distance of the surface of a turned part from its target. Above zero: material is left; below: too much was cut.
// mm.
struct TargetDeviation {
  struct Extreme {
    double distance = 0.0;
    ProfilePoint at{0, 0};  // position on the part, z in the target's coordinates
  };
  // Deviations of the outer and the inner surface at each sample of the part in the range. NaN for an inner one if
  // there is no bore, and for an outer one if neither part nor target has material.
  std::vector<double> outer, inner;
  // The largest deviations, flat ends and missing bores included; 0 if nothing is over or under.
  Extreme largestOver, largestUnder;

  double largest() const { return std::max(largestOver.distance, -largestUnder.distance); }
};

// The whole part, of any length.
inline constexpr AxisRange kWholeAxis{-std::numeric_limits<double>::infinity(),
                                      std::numeric_limits<double>::infinity()};

// Returns the range of a part that is to become its target. It begins at the lower end of the target: the material that
// the chuck holds behind it is parted off, and does not count; neither does the sample beside the step there. Material
// that stands over the other end has to be removed, and counts. base: as below; from: mm of the part, earliest begin.
AxisRange rangeOfTarget(const TargetProfile& target, const TurnedProfile& part, double base,
                        double from = kWholeAxis.from);

// Measures a part. base: mm, z of its lower end in the target's coordinates; range: range of the part, above its lower
// end. The outside of the part is measured from the outside of the target, and its bore from the bores, although the
// other side of a thin wall is nearer; if a target cannot be split (sidesOf()), everything is measured from the nearest
// surface. A bore that should not exist counts as too much cut, by its width. The result is incomplete when cancelled.
// O(samples · log segments).
TargetDeviation deviationFrom(const TargetProfile& target, const TurnedProfile& part, double base,
                              Progress progress = {}, AxisRange range = kWholeAxis);

}  // namespace handwheel
