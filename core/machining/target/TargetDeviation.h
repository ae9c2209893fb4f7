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

// How far the surface of a turned part is from its target. Above zero: material is left; below: too much was cut. mm.
struct TargetDeviation {
  struct Place {
    double distance = 0.0;
    ProfilePoint at{0, 0};  // of the part, z in the target's coordinates
  };
  // Of each sample of the part in the range: its outer and its inner surface. NaN for an inner one where there is no
  // bore, and for an outer one where neither part nor target has material.
  std::vector<double> outer, inner;
  // The furthest of all, flat ends and missing bores included; 0 where nothing is over or under.
  Place largestOver, largestUnder;

  double largest() const { return std::max(largestOver.distance, -largestUnder.distance); }
};

// All of a part, whatever its length.
inline constexpr AxisRange kWholeAxis{-std::numeric_limits<double>::infinity(),
                                      std::numeric_limits<double>::infinity()};

// The range of a part that is to become its target. It begins at the lower end of that: what the chuck holds behind it
// is parted off, and no part of it, nor is the sample beside the step there. What stands over the other end has to go,
// and counts. base: as below; from: mm, of the part, where it begins at the earliest.
AxisRange rangeOfTarget(const TargetProfile& target, const TurnedProfile& part, double base,
                        double from = kWholeAxis.from);

// Measures a part. base: mm, z of its lower end in the target's coordinates; range: of the part, above its lower end.
// The outside of the part is measured from the outside of the target, and its bore from the bores, although the other
// side of a thin wall is nearer; of a target that cannot be taken apart (sidesOf()) all from what is nearest. A bore
// where there should be none is as much too little as it is wide. The result is incomplete when cancelled. O(samples ·
// log segments).
TargetDeviation deviationFrom(const TargetProfile& target, const TurnedProfile& part, double base,
                              Progress progress = {}, AxisRange range = kWholeAxis);

}  // namespace handwheel
