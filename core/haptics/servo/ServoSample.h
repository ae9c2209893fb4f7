// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"
#include "haptics/safety/SafetySettings.h"
#include "haptics/servo/ForceRenderer.h"

#include <cstdint>

namespace handwheel {

// Data of one tick of the servo loop, for display, plots and recordings.
struct ServoSample {
  std::uint64_t tick = 0;
  TipState tip;   // state of the tip in the scene
  ForceOut felt;  // the force that the scene asked for
  DeviceState device;
  DeviceForce sent;  // sent to the motors, in the frame of the device
  SafetyActions actions;
  double energy = 0.0;       // N·mm, energy observed by the passivity observer
  float microseconds = 0.0;  // time from reading the device to writing it
  std::uint64_t scene = 0;   // number of the scene; 0: no scene was set yet
  bool hasSource = false;    // true: the scene's force was computed; false: no scene, or the device was not ready
};

}  // namespace handwheel
