// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Effort.h"

#include <atomic>

namespace handwheel {

// Shared by a job and who watches it. Any thread.
struct JobState {
  std::atomic<bool> cancelled{false};
  std::atomic<double> fraction{0.0};  // 0…1
};

// A span of a job's progress, handed down by value to the function that does that part of the work.
class Progress {
 public:
  Progress() = default;  // nobody watches
  explicit Progress(JobState& state) : m_state(&state) {}

  // The work is to be given up: somebody cancelled it, or the effort is spent that it may take (within()).
  bool cancelled() const {
    return (m_state && m_state->cancelled.load(std::memory_order_relaxed)) || (m_isLimited && m_effort->isSpent());
  }

  // The same span of work, given up once this effort is spent, which must outlive it. Where there was a limit before,
  // the effort is to be a share() of it.
  Progress within(Effort& effort) const {
    Progress p = *this;
    p.m_effort = &effort;
    p.m_isLimited = true;
    return p;
  }

  // For what must come to its end: it is counted, but only who cancels stops it.
  Progress unlimited() const {
    Progress p = *this;
    p.m_isLimited = false;
    return p;
  }

  // within(), and the fraction is how much of the effort is spent, also of its shares, whatever set() says: of work
  // that is tried again and again nobody knows more.
  Progress measuredBy(Effort& effort) const {
    Progress p = within(effort);
    if (!p.m_measure) p.m_measure = &effort;
    return p;
  }

  // A share of the effort that this work may take; one of its own where there is no limit.
  Effort share(std::size_t most) const { return m_effort ? Effort(most, *m_effort) : Effort(most); }

  void spend(std::size_t steps) const {
    if (!m_effort) return;
    m_effort->spend(steps);
    if (m_measure) store(m_measure->shareSpent());
  }

  void set(double fraction) const {
    if (!m_measure) store(fraction);
  }

  // The part of this span from a to b, both in 0…1.
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
  Effort* m_effort = nullptr;
  bool m_isLimited = false;
  Effort* m_measure = nullptr;  // when measured
  double m_from = 0.0;
  double m_to = 1.0;
};

}  // namespace handwheel
