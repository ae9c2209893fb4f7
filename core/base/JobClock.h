// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"

#include <chrono>
#include <cstdint>
#include <string>

namespace handwheel {

// Measures the working time of a job, for display. The time stops while the job does not poll its cancel flag, so that
// a job that hangs does not look like one that works. A clock must be used by one thread only.
class JobClock {
 public:
  using Clock = std::chrono::steady_clock;

  // Returns the seconds from the start to the last poll that was seen. Must be called several times per second.
  int seconds(const JobState& state, Clock::time_point now = Clock::now()) {
    const std::uint32_t polls = state.polls.load(std::memory_order_relaxed);
    if (polls != m_polls) m_lastSeen = now;
    m_polls = polls;
    return static_cast<int>(std::chrono::duration_cast<std::chrono::seconds>(m_lastSeen - m_start).count());
  }

 private:
  Clock::time_point m_start = Clock::now();
  Clock::time_point m_lastSeen = m_start;
  std::uint32_t m_polls = 0;
};

// Formats a time as minutes and seconds, "1:05". The result is empty for the first seconds, which are not worth
// displaying.
inline std::string elapsedText(int seconds) {
  constexpr int kWorthIt = 3;
  if (seconds < kWorthIt) return {};
  const std::string rest = std::to_string(seconds % 60);
  return std::to_string(seconds / 60) + (rest.size() < 2 ? ":0" : ":") + rest;
}

}  // namespace handwheel
