// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"
#include "haptics/ServoClock.h"

namespace handwheel {

// The simulated hand, as the session knows it.
inline constexpr const char* kSimulatedDriver = "simulated";
inline constexpr const char* kSimulatedAddress = "hand";

// The devices that need no hardware: the window makes them itself, as it leads them. Their names are translated.
std::vector<DeviceListing> builtInDevices();

// Null for any other. The clock outlives the device. Any thread.
std::unique_ptr<Device> makeBuiltIn(const std::string& driver, ServoClock& clock);

}  // namespace handwheel
