// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "machining/target/ProfileSegment.h"

#include <vector>

namespace handwheel {

// Joins the segments of one outline, which come in any order and direction, in order. gap: mm, ends nearer than this
// are joined. Duplicates count once. Two open outlines whose ends are at the same heights are joined by flat faces. O(n
// log n). Errors: TargetError::SeveralProfiles, CrossesItself if more than two ends meet, Cancelled.
Result<std::vector<ProfileSegment>> joinedOutline(const std::vector<ProfileSegment>& segments, double gap,
                                                  Progress progress = {});

}  // namespace handwheel
