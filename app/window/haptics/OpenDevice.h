// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/ForceRecorder.h"
#include "window/WindowServices.h"
#include "window/haptics/HapticSession.h"

namespace handwheel {

inline QString nameOf(const DeviceListing& listing) {
  return QString::fromStdString(listing.name.empty() ? listing.driver : listing.name);
}

// What there is of a session only while a device is open.
struct HapticSession::OpenDevice {
  DeviceCapabilities capabilities;
  MouseDevice* mouse = nullptr;  // of the loop, when it is that
  SimulatedDevice* hand = nullptr;
  Need need;
  std::uint64_t ticksBefore = 0;  // that the service had counted
  std::shared_ptr<ServoLoop> loop;
  std::unique_ptr<ForceRecorder> recorder;  // goes before its loop
  std::optional<ServoSample> sample;
  bool isMoving = false;                    // the view changes just now, and
  std::unique_ptr<HapticScene> movedScene;  // this is the scene for the new one
  std::optional<double> isChangingSince;    // s by the clock of the loop: its settings
};

}  // namespace handwheel
