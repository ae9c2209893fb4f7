// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/Clock.h"

#include <atomic>
#include <cmath>

namespace handwheel {

// Time that passes only when somebody sleeps. Any thread.
class FakeClock final : public Clock {
 public:
  double now() noexcept override { return static_cast<double>(m_microseconds.load()) * 1e-6; }
  void sleep(double seconds) noexcept override { m_microseconds += static_cast<long long>(std::ceil(seconds * 1e6)); }

 private:
  std::atomic<long long> m_microseconds{0};
};

}  // namespace handwheel
