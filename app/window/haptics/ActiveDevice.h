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
  MouseDevice* mouse = nullptr;  // the open device; null: it is not a mouse
  SimulatedDevice* hand = nullptr;
  ServiceHandle need;
  std::uint64_t ticksBefore = 0;  // ticks of the service before this device was opened
  std::shared_ptr<ServoLoop> loop;
  std::unique_ptr<ForceRecorder> recorder;  // declared after the loop, so that it is destroyed before the loop
  std::optional<ServoSample> sample;
  std::optional<double> failedAt;            // s by the clock of the loop; start of the present failure of the device
  bool isMoving = false;                     // the view is being changed, and scenes are stored in movedScene
  std::unique_ptr<HapticScene> movedScene;   // scene for the new view
  std::optional<std::uint64_t> jumpedAfter;  // last tick before a requested jump of the tip; none: the jump is done
  std::optional<double> isChangingSince;     // s by the clock of the loop; start of a change of its settings
};

}  // namespace handwheel
