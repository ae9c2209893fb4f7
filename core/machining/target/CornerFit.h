// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/ProfileSegment.h"

#include <vector>

namespace handwheel {

// Restores the corners of a profile that was sampled at equal steps of z. A line across a single step is replaced by
// the corner in which its neighbours meet, or by a flat face if it is a shoulder. It is kept if otherwise one of its
// ends would be further than the tolerance from the profile. spacing: the distance of the samples, mm. tolerance: mm.
// O(segments).
std::vector<ProfileSegment> sharpened(std::vector<ProfileSegment> segments, double spacing, double tolerance);

// Return the segment extended or shortened so that it ends, or begins, at a point on its line or circle.
ProfileSegment endedAt(const ProfileSegment& segment, const ProfilePoint& end);
ProfileSegment begunAt(const ProfileSegment& segment, const ProfilePoint& start);

}  // namespace handwheel
