// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"

#include <time.h>
#include <chrono>

namespace handwheel {

std::uint64_t threadCpuNanoseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);  // cannot fail for the calling thread
  return static_cast<std::uint64_t>(time.tv_sec) * 1'000'000'000u + static_cast<std::uint64_t>(time.tv_nsec);
}

CpuTimes CpuTimes::now() {
  const std::chrono::duration<double, std::milli> clock = std::chrono::steady_clock::now().time_since_epoch();
  return {clock.count(), static_cast<double>(threadCpuNanoseconds()) * 1e-6};
}

}  // namespace handwheel
