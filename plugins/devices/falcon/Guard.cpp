// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "falcon/Firmware.h"
#include "falcon/LibusbTransport.h"
#include "falcon/Session.h"
#include "io/DeviceHostProcess.h"

// Holds a Falcon for the program.
int main(int argc, char** argv) {
  using namespace handwheel;
  return runDeviceHost(argc, argv, [](const std::string& address) {
    const auto connect = [usb = falcon::Usb(), address] { return usb.open(address); };
    return std::make_unique<falcon::Session>(connect, falcon::readFirmware, std::make_shared<SteadyClock>());
  });
}
