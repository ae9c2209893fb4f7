// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "builtin/Drivers.h"

namespace handwheel {

std::vector<std::unique_ptr<DeviceDriver>> registeredDrivers() {
  return {};
}

}  // namespace handwheel
