// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/WorkBudget.h"

#include <atomic>
#include <cmath>
#include <cstdint>

namespace handwheel {

// The progress and the cancel flag of a job. Shared by the job and its observers; any thread.
struct JobState {
  std::atomic<bool> cancelled{false};
  std::atomic<double> fraction{0.0};    // 0…1
  std::atomic<std::uint32_t> polls{0};  // number of polls of the flag: it grows as long as the work goes on
};

// Reports progress within a range of a job, and checks for cancellation. Passed by value to the function that does that
// part of the work.
class Progress {
 public:
  Progress() = default;  // not observed
  explicit Progress(JobState& state) : m_state(&state) {}

  // Returns true if the work is to be abandoned: it was cancelled, or the effort that limits it (within()) is spent.
  bool cancelled() const {
    if (m_state) m_state->polls.fetch_add(1, std::memory_order_relaxed);
    return (m_state && m_state->cancelled.load(std::memory_order_relaxed)) || (m_isLimited && m_effort->isSpent());
  }

  // Returns the same range, abandoned once this effort is spent; the effort must outlive it. If there was a limit
  // before, the effort is to be a share() of it.
  Progress within(WorkBudget& effort) const {
    Progress p = *this;
    p.m_effort = &effort;
    p.m_isLimited = true;
    return p;
  }

  // Returns the same range without the limit, for work that must be completed: steps are counted, but only cancelling
  // stops it.
  Progress unlimited() const {
    Progress p = *this;
    p.m_isLimited = false;
    return p;
  }

  // Returns the same as within(), but the reported fraction is the square root of the share of the effort that is
  // spent, its shares included, and set() is ignored. For repeated trials there is no better estimate; most end early,
  // and the root is seen to move then.
  Progress measuredBy(WorkBudget& effort) const {
    Progress p = within(effort);
    if (!p.m_measure) p.m_measure = &effort;
    return p;
  }

  // Returns a share of the effort that this work may take; an effort of its own if there is no limit.
  WorkBudget share(std::size_t most) const { return m_effort ? WorkBudget(most, *m_effort) : WorkBudget(most); }

  void spend(std::size_t steps) const {
    if (!m_effort) return;
    m_effort->spend(steps);
    if (m_measure) store(std::sqrt(m_measure->shareSpent()));
  }

  void set(double fraction) const {
    if (!m_measure) store(fraction);
  }

  // Returns the sub-range from a to b, both in 0…1.
  Progress part(double a, double b) const {
    Progress p = *this;
    if (m_measure) return p;
    p.m_from = m_from + (m_to - m_from) * a;
    p.m_to = m_from + (m_to - m_from) * b;
    return p;
  }

 private:
  void store(double fraction) const {
    if (m_state) m_state->fraction.store(m_from + (m_to - m_from) * fraction, std::memory_order_relaxed);
  }

  JobState* m_state = nullptr;
  WorkBudget* m_effort = nullptr;
  bool m_isLimited = false;
  WorkBudget* m_measure = nullptr;  // null: not measured
  double m_from = 0.0;
  double m_to = 1.0;
};

}  // namespace handwheel
