// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "HapticDevices.h"
#include "haptics/servo/ServoTick.h"

namespace handwheel::test {

// A servo tick on a virtual clock, with a scripted device.
struct Rig {
  std::shared_ptr<ScriptedDevice::Log> log = std::make_shared<ScriptedDevice::Log>();
  ScriptedDevice device{log};
  VirtualClock clock;
  ServoChannel channel{4096};
  ServoTick tick{device, {}, clock, channel};
  std::int64_t time = 0;

  ServoSample run(std::int64_t step = kMillisecond) {
    time += step;
    clock.set(time);
    tick.run(time);
    return channel.latest.read();
  }
  // Runs the given number of ticks and returns the last sample.
  ServoSample runMany(int count) {
    ServoSample sample;
    for (int i = 0; i < count; ++i) sample = run();
    return sample;
  }
  // Waits in free space until the force ramp is over, then moves to x in half a second. Returns the last sample.
  ServoSample pressTo(double x) {
    log->state.position = {-1, 0, 0};
    runMany(1500);
    for (int i = 1; i <= 500; ++i) {
      log->state.position.x() = -1 + (x + 1) * i / 500;
      run();
    }
    return runMany(200);
  }
};

}  // namespace handwheel::test
