// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/device/ServoClock.h"

#include <time.h>
#include <cerrno>

namespace handwheel {

namespace {
constexpr std::int64_t kSecond = 1'000'000'000;
}

std::int64_t MonotonicClock::now() noexcept {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);  // in the process, without a system call, where the kernel's vDSO can
  return time.tv_sec * kSecond + time.tv_nsec;
}

void MonotonicClock::waitUntil(std::int64_t time) noexcept {
  const timespec until{time / kSecond, time % kSecond};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

}  // namespace handwheel
