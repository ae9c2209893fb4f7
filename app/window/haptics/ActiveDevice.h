// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/recording/ForceRecorder.h"
#include "window/WindowServices.h"
#include "window/haptics/HapticSession.h"

namespace handwheel {

// The name of the device, or of its driver when it has none.
inline QString nameOf(const DeviceInfo& listing) {
  return QString::fromStdString(listing.name.empty() ? listing.driver : listing.name);
}

// The part of a session that exists only while a device is open.
struct HapticSession::ActiveDevice {
  DeviceCapabilities capabilities;
  MouseDevice* mouse = nullptr;  // the device of the loop, when it is a mouse
  SimulatedDevice* hand = nullptr;
  ServiceHandle need;
  std::uint64_t ticksBefore = 0;  // ticks of the service before this device was opened
  std::shared_ptr<ServoLoop> loop;
  std::unique_ptr<ForceRecorder> recorder;  // destroyed before its loop
  std::optional<ServoSample> sample;
  std::optional<double> failedAt;            // s by the clock of the loop: since when it has failed
  bool isMoving = false;                     // the view is being changed, and
  std::unique_ptr<HapticScene> movedScene;   // this is the scene for the new one
  std::optional<std::uint64_t> jumpedAfter;  // tick: the tip was made to jump then, and may not have yet
  std::optional<double> isChangingSince;     // s by the clock of the loop: start of a change of its settings
};

}  // namespace handwheel
