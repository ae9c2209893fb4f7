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

// Returns true if the firmware is already running. It stays loaded until the power is off. Leaves the port in running
// mode. False also when the device is gone.
bool runs(FtdiPort& port, Clock& clock) noexcept;

// Loads the firmware, which often fails and is tried ten times. Leaves the port in running mode.
// Errors: Cancelled, Unreachable (gone), NotResponding (what it did not answer).
Status loadFirmware(FtdiPort& port, Clock& clock, const Firmware& firmware, Progress progress);

}  // namespace handwheel::falcon
