// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/TargetProfile.h"

#include <vector>

namespace handwheel {

// The outside and the bores of a target as separate profiles. The outside is the part without its bores. A bore is
// treated as a solid part that continues beyond its opening. Thus the distance of a wall from its own nominal surface
// is known even if the other side of the wall is nearer.
struct TargetSides {
  TargetProfile outside;
  std::vector<TargetProfile> bores;  // one through bore, or at most one from each end
};

// Returns the sides of a part. The outline from its lowest to its highest edge is the outside; the rest of the outline
// forms the bores. Errors: the errors of TargetProfile::make() if a side alone is not a sound outline. O(segments · log
// segments).
Result<TargetSides> sidesOf(const TargetProfile& part);

}  // namespace handwheel
