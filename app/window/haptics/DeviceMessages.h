// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/PluginLoader.h"
#include "panels/MessageBar.h"

namespace handwheel {

// Messages to the user about devices, translated.
Message notOpenedMessage(const QString& name, const Error& error);
// status: Absent or Failed, after it was there. The action, which opens it again, is to be added: a device that its
// driver lists always never seems to come back.
Message lostMessage(const QString& name, DeviceStatus status);
Message unusedPluginMessage(const PluginInfo& plugin);  // with its error

}  // namespace handwheel
