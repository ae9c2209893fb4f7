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
  std::optional<DeviceInfo> chosen;  // not among the found devices if it is unplugged
  DeviceCapabilities capabilities;   // capabilities of the chosen device
  DeviceStatus status = DeviceStatus::Absent;
  std::vector<std::string> spaceMice;  // names of the SpaceMouse devices that move the view
  bool isPointer = false;              // the mouse is used as a device
  bool isLed = false;                  // the hand at the device is simulated, and moved in the panel
  bool isForceOn = false;
};

// The state of the servo loop, for display.
struct ServoLoopStatus {
  double rate = 0.0;  // measured ticks per second
  std::uint64_t missedTicks = 0;
  RealTimeState realTime = RealTimeState::NotRunning;
};

}  // namespace handwheel
