// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "devices/DeviceCatalogue.h"

namespace handwheel {

// Syntax of "handwheel devices", which lists the connected haptic and pointing devices.
CommandSpec devicesSpec();
// Runs the command and returns the exit code. drivers: the built-in drivers.
int runDevices(const Arguments& arguments, std::vector<std::unique_ptr<DeviceDriver>> drivers);

}  // namespace handwheel
