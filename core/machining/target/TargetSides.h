// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/TargetProfile.h"

#include <vector>

namespace handwheel {

// The sides of a target as parts of their own: the outside, and the bores. The outside is the part without bores; a
// bore is what it would be if it was a part, going on beyond the opening. So the distance of a wall from where it is to
// be is known although the other side of it is nearer.
struct TargetSides {
  TargetProfile outside;
  std::vector<TargetProfile> bores;  // one right through, or at most one from each end
};

// The sides of a part. What is open upwards or downwards inside of its highest and lowest edges is a bore. Errors:
// those of TargetProfile::make(), where a side alone is no sound outline. O(segments · log segments).
Result<TargetSides> sidesOf(const TargetProfile& part);

}  // namespace handwheel
