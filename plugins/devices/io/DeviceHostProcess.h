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

// Starts a guard process and connects to it through an unnamed socket, to which no other process can connect. The guard
// is in a session of its own, so that signals from the terminal to the program do not reach it. Error: Unreachable with
// the system's reason.
Result<std::unique_ptr<ByteStream>> startGuard(const std::string& path, const std::string& address);

// Creates a session with a device that a guard process holds. path: the path of the guard program; address: the address
// of the device; kind, name: see OutOfProcessSession.
std::unique_ptr<Session> guarded(const std::string& path, const std::string& address, const DeviceCapabilities& kind,
                                 const std::string& name);

// Runs a guard process: its main() calls only this function. Serves the session that make() creates for the address
// until the program that started the guard is gone. Returns the exit code.
int runDeviceHost(int argc, char** argv,
                  const std::function<std::unique_ptr<Session>(const std::string& address)>& make);

}  // namespace handwheel
