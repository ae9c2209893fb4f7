// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "machining/target/ProfileSegment.h"

#include <vector>

namespace handwheel {

// The segments of a half section as TargetProfile keeps them.
struct CheckedOutline {
  std::vector<ProfileSegment> segments;
  bool isClosed = false;  // a part that is bored through
};

// Brings the segments of a half section into order: see TargetProfile::make().
Result<CheckedOutline> checkedOutline(std::vector<ProfileSegment> segments, Progress progress = {});

}  // namespace handwheel
