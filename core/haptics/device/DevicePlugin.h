// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

// Version of the plugin interface, which is stored in the plugin's metadata. It must match exactly, and is compared
// before any code of the plugin is loaded. It must be incremented with every change of Device.h, Error.h or this file.
#define HANDWHEEL_DEVICE_PLUGIN "handwheel.device/3"

namespace handwheel {

// Interface of the root object of a device plugin. A plugin is never unloaded, because its driver may live until the
// program ends.
class DevicePlugin {
 public:
  virtual ~DevicePlugin() = default;
  virtual std::unique_ptr<DeviceDriver> driver() = 0;
};

}  // namespace handwheel
