// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/DeviceHostProcess.h"
#include "io/FileStream.h"
#include "polhem/Session.h"

// Holds a Polhem for the program.
int main(int argc, char** argv) {
  using namespace handwheel;
  return runDeviceHost(argc, argv, [](const std::string& address) {
    const auto connect = [address] { return openSerial(address); };
    return std::make_unique<polhem::Session>(connect, std::make_shared<SteadyClock>());
  });
}
