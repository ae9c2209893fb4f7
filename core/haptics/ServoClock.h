// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace handwheel {

// The time by which a servo loop runs, so that tests and the command line can run it on time of their own.
class ServoClock {
 public:
  virtual ~ServoClock() = default;
  // ns since some moment.
  virtual std::int64_t now() noexcept = 0;
  // Returns at or after that time; at once when it has passed.
  virtual void waitUntil(std::int64_t time) noexcept = 0;
};

// The machine's CLOCK_MONOTONIC, waited for with absolute clock_nanosleep: the only system call of a tick.
class MonotonicClock : public ServoClock {
 public:
  std::int64_t now() noexcept override;
  void waitUntil(std::int64_t time) noexcept override;
};

// Time that passes only by waiting for it. One thread.
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

inline constexpr double kNanoseconds = 1e9;  // in a second

}  // namespace handwheel
