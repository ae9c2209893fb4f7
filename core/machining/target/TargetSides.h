// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/TargetProfile.h"

#include <vector>

namespace handwheel {

// The sides of a target as parts of their own: the outside, and the bores. The outside is the part without bores; a
// bore is treated as a solid part that continues beyond the opening. So the distance of a wall from its nominal surface
// is known although the other side of the wall is nearer.
struct TargetSides {
  TargetProfile outside;
  std::vector<TargetProfile> bores;  // one through bore, or at most one from each end
};

// Returns the sides of a part. Regions that are open upwards or downwards inside of its highest and lowest edges are
// bores. Errors: those of TargetProfile::make(), if a side alone is no sound outline. O(segments · log segments).
Result<TargetSides> sidesOf(const TargetProfile& part);

}  // namespace handwheel
