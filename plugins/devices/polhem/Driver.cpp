// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "polhem/Driver.h"

#include "io/DeviceHostProcess.h"
#include "io/ThreadedDevice.h"
#include "polhem/Session.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace handwheel::polhem {

namespace {

namespace fs = std::filesystem;

std::string firstLine(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

// Returns true for the serial port of a Teensy. A tty's "device" is the interface; the USB device is the folder above
// it.
bool isTeensy(const fs::path& tty) {
  std::error_code failed;
  const fs::path interface = fs::canonical(tty / "device", failed);
  if (failed) return false;
  const fs::path device = interface.parent_path();
  return firstLine(device / "idVendor") == "16c0" && firstLine(device / "idProduct") == "0483";
}

}  // namespace

std::vector<DeviceInfo> Driver::find() {
  std::vector<DeviceInfo> all;
  std::error_code failed;
  if (const char* const port = std::getenv("HANDWHEEL_POLHEM_PORT"); port && fs::exists(port, failed)) {
    all.push_back({id(), port, "Polhem"});
  }
  for (fs::directory_iterator tty(m_sysfs, failed), end; !failed && tty != end; tty.increment(failed)) {
    const std::string name = tty->path().filename().string();
    if (name.starts_with("ttyACM") && isTeensy(tty->path())) all.push_back({id(), m_dev + "/" + name, "Polhem"});
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.address < b.address; });
  return all;
}

std::unique_ptr<Device> Driver::make(const std::string& address) {
  const std::vector<DeviceInfo> there = find();
  if (std::none_of(there.begin(), there.end(), [&](const auto& one) { return one.address == address; })) return nullptr;
  const DeviceCapabilities kind = Session({}, {}).capabilities();
  return std::make_unique<ThreadedDevice>(guarded(guardPath(id()), address, kind, "Polhem"));
}

}  // namespace handwheel::polhem
