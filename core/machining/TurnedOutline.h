// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"

#include <vector>

namespace handwheel {

// The sampled outline of one piece of a turned part. In the half plane (r, z); mm. The sides are in order, in the sense
// of a ProfileCurve: the bore that is open at the lower end, from its bottom downwards; the outside, upwards; the bore
// that is open at the upper end, downwards to its bottom. If a bore goes through, there is the outside and then the
// bore, and the outline is closed: flat ends join each side to the next.
struct TurnedOutline {
  std::vector<std::vector<ProfilePoint>> sides;
  bool isClosed = false;
  // Cavities without an opening, each upwards, from axis to axis.
  std::vector<std::vector<ProfilePoint>> cavities;
};

// Returns an outline for each piece of the part, from the lower end to the upper. O(samples).
std::vector<TurnedOutline> outlinesOf(const TurnedProfile& profile);

}  // namespace handwheel
