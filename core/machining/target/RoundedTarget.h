// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/TargetProfile.h"

namespace handwheel {

// The rounding of the sizes of a target. It is for targets that were made from a part that was turned by hand.
struct TargetRounding {
  static constexpr double kLeastStep = 1e-3, kLargestStep = 10.0;  // mm

  double step = 0.1;           // mm; step of diameters, heights and radii
  double largestFillet = 0.0;  // mm; concave fillets of up to this radius, as a nose leaves them, become sharp; 0: none
};

// Returns the same part in round sizes: its corners are at multiples of the step in diameter and height, and the radii
// of its fillets are multiples of it. Other arcs go through their rounded ends with their former angle. Segments
// shorter than the step may vanish. O(n log n). Errors: ValueOutOfRange {step}; those of TargetProfile::make(), if it
// does not allow that step.
Result<TargetProfile> rounded(const TargetProfile& target, const TargetRounding& how);

// Returns the largest distance between the surfaces of two targets, at their corners and the middles of their arcs
// (mm).
double largestDistance(const TargetProfile& a, const TargetProfile& b);

}  // namespace handwheel
