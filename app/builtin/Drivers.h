// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

namespace handwheel {

// Creates the built-in device drivers. New drivers are added here and nowhere else. Each call creates new objects.
std::vector<std::unique_ptr<DeviceDriver>> registeredDrivers();

}  // namespace handwheel
