// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/DeviceHostProcess.h"
#include "openhaptics/HdSession.h"

// The bridge: loads the manufacturer's library, and holds one of their devices for the program.
int main(int argc, char** argv) {
  using namespace handwheel;
  return runDeviceHost(argc, argv, [](const std::string& address) {
    return std::make_unique<openhaptics::HdSession>(address, std::make_shared<SteadyClock>());
  });
}
