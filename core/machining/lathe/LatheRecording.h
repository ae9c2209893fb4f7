// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/lathe/LatheRun.h"

#include <functional>

namespace handwheel {

// What was done at a lathe from a known beginning on. Repeating it gives the same part and the same crashes, bit for
// bit.
struct LatheRecording {
  static constexpr std::size_t kMostEntries = 10'000'000;

  struct Entry {
    std::uint64_t step = 0;  // before which the command came, from 0
    LatheCommand command;
  };

  LatheSetup setup;
  LatheState start;
  std::shared_ptr<const TurnedProfile> part;      // at the beginning; never null
  std::shared_ptr<const LatheMaterial> material;  // may be null
  double dt = 0.001;                              // s, of a step
  std::uint64_t steps = 0;
  std::vector<Entry> entries;  // steps never falling

  bool isFull() const { return entries.size() >= kMostEntries; }
};

// Repeats it; incomplete when it was cancelled. seen: called after each step; may be null.
LatheRun replay(const LatheRecording& recording, LatheTools tools, Progress progress = {},
                const std::function<void(const LatheStep&)>& seen = {});

}  // namespace handwheel
