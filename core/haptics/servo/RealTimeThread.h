// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace handwheel {

// Scheduling state of the servo thread.
enum class RealTimeState : std::uint8_t {
  NotRunning,
  RealTime,      // SCHED_FIFO
  NotPermitted,  // an ordinary thread: ticks are late when the machine is busy, and forces must be softer
};

// Gives the calling thread real-time priority (SCHED_FIFO). priority: 1 to 99. If RLIMIT_RTPRIO does not allow this
// priority, the highest allowed priority is used. In any case the kernel no longer coalesces the wake-ups of the thread
// (PR_SET_TIMERSLACK), which by default makes them 50 us late.
RealTimeState makeThreadRealTime(int priority);

}  // namespace handwheel
