// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "machining/program/ProgramErrors.h"

#include <cstdint>

namespace handwheel {

// The budget of computation for all contour cycles of a program together. It counts steps from segment to segment,
// about 100 ns each, because a program of a few lines can ask for any number of steps. It also checks whether the run
// is cancelled.
class CycleBudget {
 public:
  static constexpr std::uint64_t kMost = 20'000'000;

  explicit CycleBudget(Progress progress) : m_progress(progress) {}

  // Throws ProgramRefusal when the budget is spent, or when the run is cancelled.
  void spend(std::uint64_t steps, const SourceLocation& location);

 private:
  Progress m_progress;
  std::uint64_t m_done = 0, m_look = 0;
};

}  // namespace handwheel
