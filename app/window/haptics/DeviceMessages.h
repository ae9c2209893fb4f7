// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/PluginLoader.h"
#include "panels/MessageBar.h"

namespace handwheel {

// Functions that return translated messages about devices.

// Returns the message that a device could not be opened.
Message notOpenedMessage(const QString& name, const Error& error);
// Returns the message that an open device is lost. status: Absent or Failed. The caller adds an action that opens the
// device again, because the return of a device that its driver always lists cannot be detected.
Message lostMessage(const QString& name, DeviceStatus status);
Message unusedPluginMessage(const PluginInfo& plugin);  // includes the error of the plugin

}  // namespace handwheel
