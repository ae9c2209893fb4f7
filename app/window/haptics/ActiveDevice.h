// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/recording/ForceRecorder.h"
#include "window/WindowServices.h"
#include "window/haptics/HapticSession.h"

namespace handwheel {

// Returns the name of the device, or of its driver if it has none.
inline QString nameOf(const DeviceInfo& listing) {
  return QString::fromStdString(listing.name.empty() ? listing.driver : listing.name);
}

// The part of a session that exists only while a device is open.
struct HapticSession::ActiveDevice {
  DeviceCapabilities capabilities;
  MouseDevice* mouse = nullptr;  // the device of the loop, if it is a mouse
  SimulatedDevice* hand = nullptr;
  ServiceHandle need;
  std::uint64_t ticksBefore = 0;  // ticks of the service before this device was opened
  std::shared_ptr<ServoLoop> loop;
  std::unique_ptr<ForceRecorder> recorder;  // destroyed before its loop
  std::optional<ServoSample> sample;
  std::optional<double> failedAt;            // s by the clock of the loop; time since which it has failed
  bool isMoving = false;                     // the view is being changed
  std::unique_ptr<HapticScene> movedScene;   // scene for the new view
  std::optional<std::uint64_t> jumpedAfter;  // tick of the last jump of the tip, which may not have happened yet
  std::optional<double> isChangingSince;     // s by the clock of the loop; start of a change of its settings
};

}  // namespace handwheel
