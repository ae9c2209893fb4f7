// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/servo/RealTimeThread.h"

#include <pthread.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <algorithm>

namespace handwheel {

namespace {

bool setFifo(int priority) {
  const sched_param parameters{priority};
  return pthread_setschedparam(pthread_self(), SCHED_FIFO, &parameters) == 0;
}

}  // namespace

RealTimeState makeThreadRealTime(int priority) {
  prctl(PR_SET_TIMERSLACK, 1);  // ns
  if (setFifo(priority)) return RealTimeState::RealTime;
  rlimit limit{};
  if (getrlimit(RLIMIT_RTPRIO, &limit) != 0 || limit.rlim_cur == 0) return RealTimeState::NotPermitted;
  const int allowed = static_cast<int>(std::min<rlim_t>(limit.rlim_cur, static_cast<rlim_t>(priority)));
  return setFifo(allowed) ? RealTimeState::RealTime : RealTimeState::NotPermitted;
}

}  // namespace handwheel
