// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"

#include <algorithm>
#include <cstddef>

namespace handwheel {

// Steps of a loop between two polls of the cancel flag. A few milliseconds where a step is a face or a line of text.
inline constexpr std::size_t kIterationsPerPoll = std::size_t{1} << 16;
// The same where each step searches, which takes up to a few microseconds.
inline constexpr std::size_t kSearchesPerPoll = std::size_t{1} << 12;

// The Effort that all steps between two polls count as.
inline constexpr std::size_t kEffortPerPoll = 1024;

// Reports the progress of a loop and polls the cancel flag. Called before step i of n; acts every iterationsPerPoll
// steps and counts the steps that follow. False when cancelled.
inline bool pollProgress(std::size_t i, std::size_t n, const Progress& progress,
                         std::size_t iterationsPerPoll = kIterationsPerPoll) {
  if (i % iterationsPerPoll != 0) return true;
  progress.set(static_cast<double>(i) / static_cast<double>(n));
  progress.spend(kEffortPerPoll * std::min(n - std::min(i, n), iterationsPerPoll) / iterationsPerPoll);
  return !progress.cancelled();
}

}  // namespace handwheel
