// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/WorkBudget.h"

#include <atomic>
#include <cmath>
#include <cstdint>

namespace handwheel {

// The progress and the cancel flag of a job. It is shared by the job and its observers, and may be used on any thread.
struct JobState {
  std::atomic<bool> cancelled{false};
  std::atomic<double> fraction{0.0};    // 0 to 1
  std::atomic<std::uint32_t> polls{0};  // number of polls of the flag; it grows as long as the job works
};

// Reports progress within a range of a job, and checks for cancellation. It is passed by value to the function that
// does that part of the work.
class Progress {
 public:
  Progress() = default;  // progress that is not observed
  explicit Progress(JobState& state) : m_state(&state) {}

  // Returns true if the work must be abandoned, because the job was cancelled or the effort that limits it (within())
  // is spent.
  bool cancelled() const {
    if (m_state) m_state->polls.fetch_add(1, std::memory_order_relaxed);
    return (m_state && m_state->cancelled.load(std::memory_order_relaxed)) || (m_isLimited && m_effort->isSpent());
  }

  // Returns the same range with a limit: the work is abandoned once this effort is spent. The effort must outlive the
  // result. If there was a limit before, the effort must be a share() of it.
  Progress within(WorkBudget& effort) const {
    Progress p = *this;
    p.m_effort = &effort;
    p.m_isLimited = true;
    return p;
  }

  // Returns the same range without the limit, for work that must be completed. Steps are still counted, but only
  // cancellation stops the work.
  Progress unlimited() const {
    Progress p = *this;
    p.m_isLimited = false;
    return p;
  }

  // Returns the same range as within(), but with progress measured by the effort. The reported fraction is the square
  // root of the spent fraction of the effort, including its shares, and set() is ignored. For repeated trials there is
  // no better estimate: most of them end early, and the square root moves visibly even then.
  Progress measuredBy(WorkBudget& effort) const {
    Progress p = within(effort);
    if (!p.m_measure) p.m_measure = &effort;
    return p;
  }

  // Returns a part of the effort for this work, of at most this number of steps. It is an independent effort if there
  // is no limit.
  WorkBudget share(std::size_t most) const { return m_effort ? WorkBudget(most, *m_effort) : WorkBudget(most); }

  void spend(std::size_t steps) const {
    if (!m_effort) return;
    m_effort->spend(steps);
    if (m_measure) store(std::sqrt(m_measure->shareSpent()));
  }

  void set(double fraction) const {
    if (!m_measure) store(fraction);
  }

  // Returns the sub-range from a to b, which are fractions of this range, 0 to 1.
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
