// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "falcon/FtdiPort.h"
#include "io/Clock.h"

#include <vector>

namespace handwheel::falcon {

using Firmware = std::vector<std::uint8_t>;

// Returns true if the firmware is running. Returns false also if the device is gone. The firmware stays loaded until
// the power is off. The port is left in running mode.
bool runs(FtdiPort& port, Clock& clock) noexcept;

// Loads the firmware. This often fails, so it is tried ten times. The port is left in running mode. Errors: Cancelled,
// Unreachable (device gone), NotResponding (the step to which the device did not answer).
Status loadFirmware(FtdiPort& port, Clock& clock, const Firmware& firmware, Progress progress);

}  // namespace handwheel::falcon
