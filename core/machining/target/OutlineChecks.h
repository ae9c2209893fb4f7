// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "machining/target/ProfileSegment.h"

#include <vector>

namespace handwheel {

// The segments of a half section, in the order and direction of TargetProfile.
struct CheckedOutline {
  std::vector<ProfileSegment> segments;
  bool isClosed = false;  // the part is bored through
};

// Checks the segments of a half section, and orders and joins them by the rules of TargetProfile::make(). Errors: the
// errors of that function.
Result<CheckedOutline> checkedOutline(std::vector<ProfileSegment> segments, Progress progress = {});

}  // namespace handwheel
