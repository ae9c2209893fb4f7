// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/drilling/DrillRecord.h"

#include <memory>
#include <span>
#include <vector>

namespace handwheel {

// A hole that was drilled in an exercise. It may have been undone since.
struct TriedHole {
  static constexpr std::size_t kMost = 100'000;  // largest number of stored holes

  std::uint64_t mark = 0;    // fingerprintOf() the record
  double forbidden = 0.0;    // mm, largest depth of the head in the forbidden region; 0: not entered
  std::uint32_t number = 1;  // number of its try, from 1
  bool operator==(const TriedHole&) const = default;
};
using TriedHoles = std::vector<TriedHole>;

// Returns a fingerprint of a hole: equal for the same drill on the same path at the same times.
std::uint64_t fingerprintOf(const DrillRecord& hole);

// Returns the tries with another hole, drilled in addition to the present ones. A hole that is drilled after a hole of
// the last try was undone begins another try. At kMost the oldest are dropped.
TriedHoles withHole(TriedHoles tried, std::span<const std::shared_ptr<const DrillRecord>> present,
                    const DrillRecord& hole, double forbidden);

// A try with holes in the forbidden region that were undone.
struct FailedTry {
  std::uint32_t number = 1;
  double forbidden = 0.0;  // mm, largest depth of these
};

// Returns the number of tries. tried: null if nothing was stored, as for holes of a program, which are one try.
std::uint32_t triesCounted(const TriedHoles* tried, std::span<const std::shared_ptr<const DrillRecord>> present);

struct DrillTries {
  std::uint32_t count = 0;        // including the present one
  std::vector<FailedTry> failed;  // in order
};

// Returns the tries at a drilling exercise, with those that failed. present: the holes that exist now. O(poses).
DrillTries triesOf(const TriedHoles* tried, std::span<const std::shared_ptr<const DrillRecord>> present);

}  // namespace handwheel
