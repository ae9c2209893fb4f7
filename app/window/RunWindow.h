// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"
#include "window/kinds/KindUi.h"

namespace handwheel {

// Opens the main window with the files of the command line. Returns when the window is closed. drivers: the built-in
// device drivers, in addition to those of plugins.
int runWindow(int argc, char** argv, const KindSet& kinds, std::vector<std::unique_ptr<DeviceDriver>> drivers);

}  // namespace handwheel
