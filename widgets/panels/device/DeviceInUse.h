// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"
#include "haptics/servo/RealTimeThread.h"

#include <optional>
#include <vector>

namespace handwheel {

// The devices found and the state of the chosen one, for display.
struct DeviceInUse {
  std::vector<DeviceInfo> found;
  std::optional<DeviceInfo> chosen;  // not among those found when it was unplugged
  DeviceCapabilities capabilities;   // of the chosen one
  DeviceStatus status = DeviceStatus::Absent;
  std::vector<std::string> spaceMice;  // names of those that move the view
  bool isPointer = false;              // the mouse is used as device
  bool isLed = false;                  // nobody holds it: its hand is led in the panel
  bool isForceOn = false;
};

// The state of the servo loop, for display.
struct ServoLoopStatus {
  double rate = 0.0;  // ticks a second, as measured
  std::uint64_t missedTicks = 0;
  RealTimeState realTime = RealTimeState::NotRunning;
};

}  // namespace handwheel
