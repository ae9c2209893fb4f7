// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"

#include <vector>

namespace handwheel {

// The sampled outline of one piece of a turned part. Points are (r, z) in the half plane, mm. The sides run in the
// direction of a ProfileCurve. The first is the bore that is open at the lower end, from its bottom downwards; the
// second is the outside, upwards; the third is the bore that is open at the upper end, downwards to its bottom. With a
// through bore, the sides are the outside and then the bore, and the outline is closed. Flat ends join each side to the
// next.
struct TurnedOutline {
  std::vector<std::vector<ProfilePoint>> sides;
  bool isClosed = false;
  // Cavities without an opening, as points that run upwards from axis to axis
  std::vector<std::vector<ProfilePoint>> cavities;
};

// Returns an outline for each piece of the part, from the lower end to the upper. O(samples).
std::vector<TurnedOutline> outlinesOf(const TurnedProfile& profile);

}  // namespace handwheel
