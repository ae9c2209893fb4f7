// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/Clock.h"

#include <chrono>
#include <thread>

namespace handwheel {

double SteadyClock::now() noexcept {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void SteadyClock::sleep(double seconds) noexcept {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

}  // namespace handwheel
