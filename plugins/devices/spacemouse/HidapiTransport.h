// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spacemouse/Driver.h"

namespace handwheel::spacemouse {

// Returns the HID functions of the library hidapi, which uses the kernel's hidraw nodes.
Hid hidapi();

}  // namespace handwheel::spacemouse
