// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace handwheel {

// Interface of the clock of a servo loop. Tests and the command line can run the loop in simulated time.
class ServoClock {
 public:
  virtual ~ServoClock() = default;
  // Returns the time in ns since an arbitrary origin.
  virtual std::int64_t now() noexcept = 0;
  // Waits until this time or later. Returns at once if the time has passed.
  virtual void waitUntil(std::int64_t time) noexcept = 0;
};

// Clock that uses CLOCK_MONOTONIC and absolute clock_nanosleep. The wait is the only system call of a tick, apart from
// the communication with the device.
class MonotonicClock : public ServoClock {
 public:
  std::int64_t now() noexcept override;
  void waitUntil(std::int64_t time) noexcept override;
};

// Simulated clock, whose time passes only in waitUntil(). It must be used by one thread only.
class VirtualClock : public ServoClock {
 public:
  std::int64_t now() noexcept override { return m_now; }
  void waitUntil(std::int64_t time) noexcept override {
    if (time > m_now) m_now = time;
  }
  void set(std::int64_t time) { m_now = time; }

 private:
  std::int64_t m_now = 0;
};

inline constexpr double kNanoseconds = 1e9;  // ns per second

}  // namespace handwheel
