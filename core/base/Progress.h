// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

  bool cancelled() const { return m_state && m_state->cancelled.load(std::memory_order_relaxed); }

  void set(double fraction) const {
    if (m_state) m_state->fraction.store(m_from + (m_to - m_from) * fraction, std::memory_order_relaxed);
  }

  // The part of this span from a to b, both in 0…1.
  Progress part(double a, double b) const {
    Progress p = *this;
    p.m_from = m_from + (m_to - m_from) * a;
    p.m_to = m_from + (m_to - m_from) * b;
    return p;
  }

 private:
  JobState* m_state = nullptr;
  double m_from = 0.0;
  double m_to = 1.0;
};

}  // namespace handwheel
