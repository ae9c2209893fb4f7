// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/TurnedProfile.h"
#include "machining/target/TargetProfile.h"

#include <vector>

namespace handwheel {

// How far the surface of a turned part is from its target. Above zero: material is left; below: too much was cut. mm.
struct TargetDeviation {
  struct Place {
    double distance = 0.0;
    ProfilePoint at{0, 0};  // of the part, z in the target's coordinates
  };
  // Of each sample of the part: its outer and its inner surface. NaN for an inner one where there is no bore.
  std::vector<double> outer, inner;
  // The furthest of all, flat ends and missing bores included; 0 where nothing is over or under.
  Place largestOver, largestUnder;

  double largest() const { return std::max(largestOver.distance, -largestUnder.distance); }
};

// Measures a part. base: mm, z of its lower end in the target's coordinates. The result is incomplete when cancelled.
// O(samples · log segments).
TargetDeviation deviationFrom(const TargetProfile& target, const TurnedProfile& part, double base,
                              Progress progress = {});

}  // namespace handwheel
