// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"
#include "haptics/RealTimeThread.h"

#include <optional>
#include <vector>

namespace handwheel {

// What is known of the devices, as the panel shows it.
struct DeviceInUse {
  std::vector<DeviceListing> found;
  std::optional<DeviceListing> chosen;  // not among those found when it was unplugged
  DeviceCapabilities capabilities;      // of the chosen one
  DeviceStatus status = DeviceStatus::Absent;
  bool isPointer = false;  // the mouse in the place of a device
  bool isForceOn = false;
};

// How the servo loop runs.
struct LoopView {
  double rate = 0.0;  // ticks a second, as measured
  std::uint64_t missedTicks = 0;
  RealTimeState realTime = RealTimeState::NotRunning;
};

}  // namespace handwheel
