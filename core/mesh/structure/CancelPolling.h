// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"

#include <algorithm>
#include <cstddef>

namespace handwheel {

// Number of steps of a loop between two polls of the cancel flag. They take a few milliseconds if a step is a face or a
// line of text.
inline constexpr std::size_t kIterationsPerPoll = std::size_t{1} << 16;
// Number of steps between two polls in loops that search; such a step takes up to a few microseconds.
inline constexpr std::size_t kSearchesPerPoll = std::size_t{1} << 12;

// Work that is counted for all steps between two polls, in steps of WorkBudget.
inline constexpr std::size_t kEffortPerPoll = 1024;

// Reports the progress of a loop and polls the cancel flag. It must be called before each step i of n. It acts only
// every iterationsPerPoll steps, and counts the effort of the steps up to the next poll. Returns false if cancelled.
inline bool pollProgress(std::size_t i, std::size_t n, const Progress& progress,
                         std::size_t iterationsPerPoll = kIterationsPerPoll) {
  if (i % iterationsPerPoll != 0) return true;
  progress.set(static_cast<double>(i) / static_cast<double>(n));
  progress.spend(kEffortPerPoll * std::min(n - std::min(i, n), iterationsPerPoll) / iterationsPerPoll);
  return !progress.cancelled();
}

}  // namespace handwheel
