// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/TargetProfile.h"

namespace handwheel {

// The rounding of the sizes of a target. It is meant for targets made from a part that was turned by hand.
struct TargetRounding {
  static constexpr double kLeastStep = 1e-3, kLargestStep = 10.0;  // mm

  double step = 0.1;           // mm, step of diameters, heights and radii
  double largestFillet = 0.0;  // mm; concave fillets up to this radius, as a nose leaves, become sharp; 0: none
};

// Returns a target with rounded sizes. The diameters and heights of its corners and the radii of its fillets are
// multiples of the step. Other arcs join their rounded ends and keep their angle. Segments shorter than the step may
// vanish. O(n log n). Errors: ValueOutOfRange {step}, and the errors of TargetProfile::make() if the rounded outline is
// not a valid profile.
Result<TargetProfile> rounded(const TargetProfile& target, const TargetRounding& how);

// Returns the largest distance (mm) between the surfaces of two targets, measured at their corners and at the middles
// of their arcs.
double largestDistance(const TargetProfile& a, const TargetProfile& b);

}  // namespace handwheel
