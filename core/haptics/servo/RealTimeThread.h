// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace handwheel {

// Scheduling state of the servo thread.
enum class RealTimeState : std::uint8_t {
  NotRunning,
  RealTime,      // SCHED_FIFO
  NotPermitted,  // runs like any thread: ticks come late when the machine is busy, and forces must be softer
};

// Gives the calling thread real-time priority (SCHED_FIFO). priority: 1 to 99; or the highest below it that
// RLIMIT_RTPRIO allows. In any case the kernel no longer coalesces its wake-ups (PR_SET_TIMERSLACK, by default 50 us
// late).
RealTimeState makeThreadRealTime(int priority);

}  // namespace handwheel
