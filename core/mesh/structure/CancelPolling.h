// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"

#include <algorithm>
#include <cstddef>

namespace handwheel {

// Steps of a loop between two polls of the cancel flag. They take a few milliseconds if a step is a face or a line of
// text.
inline constexpr std::size_t kIterationsPerPoll = std::size_t{1} << 16;
// The same for steps that search, which take up to a few microseconds each.
inline constexpr std::size_t kSearchesPerPoll = std::size_t{1} << 12;

// The Effort counted for all steps between two polls.
inline constexpr std::size_t kEffortPerPoll = 1024;

// Reports the progress of a loop and polls the cancel flag. Must be called before step i of n; acts every
// iterationsPerPoll steps and counts the steps that follow. Returns false if cancelled.
inline bool pollProgress(std::size_t i, std::size_t n, const Progress& progress,
                         std::size_t iterationsPerPoll = kIterationsPerPoll) {
  if (i % iterationsPerPoll != 0) return true;
  progress.set(static_cast<double>(i) / static_cast<double>(n));
  progress.spend(kEffortPerPoll * std::min(n - std::min(i, n), iterationsPerPoll) / iterationsPerPoll);
  return !progress.cancelled();
}

}  // namespace handwheel
