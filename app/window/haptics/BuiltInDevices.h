// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"
#include "haptics/device/ServoClock.h"

namespace handwheel {

// Driver id and address of the simulated device, which is moved by scripts.
inline constexpr const char* kSimulatedDriver = "simulated";
inline constexpr const char* kSimulatedAddress = "hand";
// Driver id of the mouse as device.
inline constexpr const char* kMouseDriver = "mouse";

// Returns the devices that need no hardware. The window creates these devices itself, because it controls their motion.
// Their names are translated.
std::vector<DeviceInfo> builtInDevices();

// Creates a built-in device; returns null for any other driver. The clock must outlive the device. May be called on any
// thread.
std::unique_ptr<Device> makeBuiltIn(const DeviceInfo& listing, ServoClock& clock);

}  // namespace handwheel
