// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"

// The version of what a plugin and the program say to each other, in the plugin's metadata. It is compared, to the
// letter, before any code of the plugin is loaded. Count it up with every change of Device.h or of this file.
#define HANDWHEEL_DEVICE_PLUGIN "handwheel.device/2"

namespace handwheel {

// What the root object of a device plugin is. A plugin is never unloaded; its driver may live to the end of the
// program.
class DevicePlugin {
 public:
  virtual ~DevicePlugin() = default;
  virtual std::unique_ptr<DeviceDriver> driver() = 0;
};

}  // namespace handwheel
