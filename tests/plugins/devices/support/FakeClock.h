// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/Clock.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

namespace handwheel {

// A clock whose time passes only during calls of sleep(). It may be used on any thread.
class FakeClock final : public Clock {
 public:
  enum class Pace { None, Real };
  // pace: use Pace::Real for a device on a thread of its own, which would otherwise keep a processor busy, perhaps at
  // real-time priority.
  explicit FakeClock(Pace pace = Pace::None) : m_pace(pace) {}

  double now() noexcept override { return static_cast<double>(m_microseconds.load()) * 1e-6; }
  void sleep(double seconds) noexcept override { m_microseconds += static_cast<long long>(std::ceil(seconds * 1e6)); }

  // Sleeps for a short real time if the pace is Real. To be called by the emulated transports for each transfer.
  void pace() const {
    if (m_pace == Pace::Real) std::this_thread::sleep_for(std::chrono::microseconds(200));
  }

 private:
  Pace m_pace;
  std::atomic<long long> m_microseconds{0};
};

}  // namespace handwheel
