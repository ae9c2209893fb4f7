// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/drilling/DrillRecord.h"

#include <memory>
#include <span>
#include <vector>

namespace handwheel {

// A hole that was drilled in work on an exercise. It may have been taken back since.
struct TriedHole {
  static constexpr std::size_t kMost = 100'000;  // that are kept

  std::uint64_t mark = 0;    // fingerprintOf() its record
  double forbidden = 0.0;    // mm, deepest of the head in the forbidden region; 0: it was not entered
  std::uint32_t number = 1;  // of the try that it belongs to, from 1
  bool operator==(const TriedHole&) const = default;
};
using TriedHoles = std::vector<TriedHole>;

// How a hole was drilled, as a number: the same for the same drill that went the same way at the same times.
std::uint64_t fingerprintOf(const DrillRecord& hole);

// The tries with a hole that was drilled beside those that are there now. What is drilled after a hole of the last try
// was taken back is another try. At kMost the oldest are left out.
TriedHoles withHole(TriedHoles tried, std::span<const std::shared_ptr<const DrillRecord>> present,
                    const DrillRecord& hole, double forbidden);

// A try with holes in the forbidden region that were taken back.
struct FailedTry {
  std::uint32_t number = 1;
  double forbidden = 0.0;  // mm, deepest of these
};

// How many there are. tried: null: nothing was kept, as of holes of a program, which are one try.
std::uint32_t triesCounted(const TriedHoles* tried, std::span<const std::shared_ptr<const DrillRecord>> present);

struct DrillTries {
  std::uint32_t count = 0;        // the present one included
  std::vector<FailedTry> failed;  // in order
};

// The tries at a drilling exercise, with those that failed. present: the holes that are there now. O(poses).
DrillTries triesOf(const TriedHoles* tried, std::span<const std::shared_ptr<const DrillRecord>> present);

}  // namespace handwheel
