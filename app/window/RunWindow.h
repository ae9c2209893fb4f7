// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"
#include "window/KindUi.h"

namespace handwheel {

// Opens the main window with the files named on the command line and runs until it is closed. drivers: of devices, as
// the program has them besides those of plugins.
int runWindow(int argc, char** argv, const KindSet& kinds, std::vector<std::unique_ptr<DeviceDriver>> drivers);

}  // namespace handwheel
