// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "machining/target/ProfileSegment.h"

#include <vector>

namespace handwheel {

// Returns the segments of one outline in order. The given segments may be in any order and direction; duplicates count
// once. Two open outlines whose ends are at the same heights are joined by flat faces. gap: the distance (mm) below
// which ends are joined. O(n log n). Errors: TargetError::SeveralProfiles, CrossesItself if more than two ends meet,
// Cancelled.
Result<std::vector<ProfileSegment>> joinedOutline(const std::vector<ProfileSegment>& segments, double gap,
                                                  Progress progress = {});

}  // namespace handwheel
