// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// Error codes of haptic devices and of the plugins that support them.
namespace handwheel::DeviceError {

extern const ErrorDescription Unreachable;    // {reason}
extern const ErrorDescription NotResponding;  // {expected answer}
extern const ErrorDescription PluginVersion;  // {version of its interface, version of the program's}
extern const ErrorDescription PluginBroken;   // {reason}

}  // namespace handwheel::DeviceError
