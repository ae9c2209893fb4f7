// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/PluginLoader.h"
#include "panels/MessageBar.h"

namespace handwheel {

// Messages to the user about devices, translated.
Message notOpenedMessage(const QString& name, const Error& error);
// status: Absent or Failed, after the device was there. The caller adds the action, which opens the device again: a
// device that its driver always lists never seems to return.
Message lostMessage(const QString& name, DeviceStatus status);
Message unusedPluginMessage(const PluginInfo& plugin);  // includes the error of the plugin

}  // namespace handwheel
