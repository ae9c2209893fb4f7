// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "io/OutOfProcessSession.h"

#include <memory>
#include <string>

namespace handwheel {

// Returns the path of a guard program. It is in the folder "guards" next to the folder of the calling plugin, or in the
// folder in HANDWHEEL_GUARDS.
std::string guardPath(const std::string& name);

// Starts a guard process, and connects to it by an unnamed socket. No other process can connect. It is in a session of
// its own: signals of the terminal to the program do not reach it. Error: Unreachable with the system's reason.
Result<std::unique_ptr<ByteStream>> startGuard(const std::string& path, const std::string& address);

// Creates a session with a device that a guard process holds. path: its program; address: that of the device; kind,
// name: see OutOfProcessSession.
std::unique_ptr<Session> guarded(const std::string& path, const std::string& address, const DeviceCapabilities& kind,
                                 const std::string& name);

// Runs a guard process; its main function. Serves the session that make() creates for the address, until the program is
// gone. Returns the exit code.
int runDeviceHost(int argc, char** argv,
                  const std::function<std::unique_ptr<Session>(const std::string& address)>& make);

}  // namespace handwheel
