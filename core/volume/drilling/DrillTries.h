// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/drilling/DrillRecord.h"

#include <memory>
#include <span>
#include <vector>

namespace handwheel {

// A hole that was drilled in an exercise. It may have been undone.
struct TriedHole {
  static constexpr std::size_t kMost = 100'000;  // largest number of stored holes

  std::uint64_t mark = 0;    // fingerprintOf() the hole's record
  double forbidden = 0.0;    // mm, largest depth of the head in the forbidden region; 0: not entered
  std::uint32_t number = 1;  // number of its try, starting at 1
  bool operator==(const TriedHole&) const = default;
};
using TriedHoles = std::vector<TriedHole>;

// Returns a fingerprint of a hole. It is equal for the same drill on the same path at the same times.
std::uint64_t fingerprintOf(const DrillRecord& hole);

// Returns the tries with another hole, which was drilled after the present ones. The hole starts another try if a hole
// of the last try was undone before. If there are more than kMost holes, the oldest ones are dropped.
TriedHoles withHole(TriedHoles tried, std::span<const std::shared_ptr<const DrillRecord>> present,
                    const DrillRecord& hole, double forbidden);

// A try with undone holes in the forbidden region.
struct FailedTry {
  std::uint32_t number = 1;
  double forbidden = 0.0;  // mm, largest depth of these holes in the region
};

// Returns the number of tries. tried: null if no tries are stored, as for holes of a program, which are one try.
std::uint32_t triesCounted(const TriedHoles* tried, std::span<const std::shared_ptr<const DrillRecord>> present);

struct DrillTries {
  std::uint32_t count = 0;        // number of tries, including the present one
  std::vector<FailedTry> failed;  // in the order of their numbers
};

// Returns the tries at a drilling exercise, including the failed ones. present: the holes that have not been undone.
// O(poses of the holes).
DrillTries triesOf(const TriedHoles* tried, std::span<const std::shared_ptr<const DrillRecord>> present);

}  // namespace handwheel
