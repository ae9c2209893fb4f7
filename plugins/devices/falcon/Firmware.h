// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "falcon/Bootloader.h"

#include <string>

namespace handwheel::falcon {

// Returns the path of the firmware file. It is the value of the environment variable HANDWHEEL_FALCON_FIRMWARE, or
// handwheel/falcon.bin in the user's data folder. The firmware belongs to the manufacturer of the device and cannot be
// distributed with this program, so the user must provide the file.
std::string firmwarePath();

// Reads the firmware file. Error: ReferenceMissing.
Result<Firmware> readFirmware();

}  // namespace handwheel::falcon
