// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The codes of errors of haptic devices and of the plugins that bring them.
namespace handwheel::DeviceError {

extern const ErrorDescription Unreachable;    // {reason}
extern const ErrorDescription NotResponding;  // {what it should have answered}
extern const ErrorDescription PluginVersion;  // {interface that it was made for, the program's}
extern const ErrorDescription PluginBroken;   // {reason}

}  // namespace handwheel::DeviceError
