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
  TipState tip;   // in the scene
  ForceOut felt;  // the force that the scene asked for
  DeviceState device;
  DeviceForce sent;  // to the motors, in the frame of the device
  SafetyActions actions;
  double energy = 0.0;       // N·mm, of the passivity observer
  float microseconds = 0.0;  // from reading the device to writing it
  std::uint64_t scene = 0;   // number of the scene; 0: none was set yet
  bool hasSource = false;    // the scene's force was computed; else there was none, or the device was not ready
};

}  // namespace handwheel
