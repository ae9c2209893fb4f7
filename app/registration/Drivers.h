// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"

namespace handwheel {

// The drivers of devices that need no plugin: the one place to add another. Each call makes them anew.
std::vector<std::unique_ptr<DeviceDriver>> registeredDrivers();

}  // namespace handwheel
