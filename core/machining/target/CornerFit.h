// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/ProfileSegment.h"

#include <vector>

namespace handwheel {

// Restores the corners of a profile that was sampled at equal steps of z. A line across a single step becomes the
// corner in which its neighbours meet, or a flat face if it is a shoulder; it stays if that would leave one of its ends
// further than the tolerance from the profile. spacing: mm, of the samples; tolerance: mm. O(segments).
std::vector<ProfileSegment> sharpened(std::vector<ProfileSegment> segments, double spacing, double tolerance);

// Returns the segment extended or cut so that it ends, or begins, at a point on its line or circle.
ProfileSegment endedAt(const ProfileSegment& segment, const ProfilePoint& end);
ProfileSegment begunAt(const ProfileSegment& segment, const ProfilePoint& start);

}  // namespace handwheel
