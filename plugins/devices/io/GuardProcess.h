// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "io/GuardedSession.h"

#include <memory>
#include <string>

namespace handwheel {

// The program of that name in the folder "guards" beside the folder of the plugin that asks; another folder, where
// HANDWHEEL_GUARDS says so.
std::string guardPath(const std::string& name);

// Starts it, with a socket to it that has no name, so that nobody else can take part. It is a session of its own: what
// the terminal sends to the program does not reach it. Error: DeviceUnreachable with the system's reason.
Result<std::unique_ptr<ByteStream>> startGuard(const std::string& path, const std::string& address);

// A session with the device at this address in a process that path names. kind, name: as GuardedSession has them.
std::unique_ptr<Session> guarded(const std::string& path, const std::string& address, const DeviceCapabilities& kind,
                                 const std::string& name);

// The whole of such a process but for its session: serves the one that make() gives for the address, until the program
// is gone. The exit code.
int runGuard(int argc, char** argv, const std::function<std::unique_ptr<Session>(const std::string& address)>& make);

}  // namespace handwheel
