// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"

#include <algorithm>
#include <cstddef>

namespace handwheel {

// Steps of a loop between two looks at the cancel flag: a few milliseconds where a step is a face or a line of text.
inline constexpr std::size_t kStepsPerLook = std::size_t{1} << 16;
// The same where each step searches, which takes up to a few microseconds.
inline constexpr std::size_t kSearchesPerLook = std::size_t{1} << 12;

// What all steps between two looks count as, of Effort.
inline constexpr std::size_t kEffortPerLook = 1024;

// Called before step i of n: now and then reports how far the loop is, counts the steps that follow, and looks. False
// when cancelled.
inline bool mayGoOn(std::size_t i, std::size_t n, const Progress& progress, std::size_t stepsPerLook = kStepsPerLook) {
  if (i % stepsPerLook != 0) return true;
  progress.set(static_cast<double>(i) / static_cast<double>(n));
  progress.spend(kEffortPerLook * std::min(n - std::min(i, n), stepsPerLook) / stepsPerLook);
  return !progress.cancelled();
}

}  // namespace handwheel
