// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/drilling/DrillMonitor.h"
#include "volume/drilling/DrillRecord.h"

#include <memory>
#include <span>

namespace handwheel {

// The evaluation of a drilled hole by replaying its cycles.
struct DrillReview {
  static constexpr double kEndOfBone = 1.0;  // mm of depth before the breakthrough

  std::vector<DrillMoment> moments;
  DrillStatistics figures;
  std::optional<double> lastThrust;  // N, mean over time of the thrust in the last kEndOfBone before the breakthrough
  SparseVolume left;                 // remaining volume
};

// Replays the records of holes in a volume and compares them with the plan. The result is deterministic, or empty if
// cancelled. O(poses).
std::optional<DrillReview> reviewDrilling(SparseVolume stock, const DrillPlan& plan,
                                          std::span<const std::shared_ptr<const DrillRecord>> holes,
                                          Progress progress = {});

}  // namespace handwheel
