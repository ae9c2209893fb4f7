// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "falcon/Driver.h"

#include "falcon/Session.h"
#include "io/ThreadedDevice.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

namespace handwheel::falcon {

namespace {

constexpr std::size_t kLargest = 1 << 20;  // bytes; the known ones have about 8,000

Result<Firmware> readFirmware() {
  const std::string path = firmwarePath();
  std::ifstream stream(path, std::ios::binary);
  Firmware bytes(kLargest);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  if (bytes.empty()) {
    const std::string name = path.substr(path.rfind('/') + 1);
    return Error{ErrorCode::ReferenceMissing, {"the firmware file", name}, {}, path};
  }
  return bytes;
}

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

std::string firmwarePath() {
  if (std::string path = variable("HANDWHEEL_FALCON_FIRMWARE"); !path.empty()) return path;
  std::string folder = variable("XDG_DATA_HOME");
  if (folder.empty()) folder = variable("HOME") + "/.local/share";
  return folder + "/handwheel/falcon.bin";
}

std::vector<DeviceListing> Driver::find() {
  std::vector<DeviceListing> all;
  for (std::string& address : m_usb.find()) all.push_back({id(), std::move(address), "Novint Falcon"});
  return all;
}

std::unique_ptr<Device> Driver::make(const std::string& address) {
  const std::vector<std::string> there = m_usb.find();
  if (std::find(there.begin(), there.end(), address) == there.end()) return nullptr;
  const auto connect = [usb = m_usb, address] { return usb.open(address); };
  return std::make_unique<ThreadedDevice>(
      std::make_unique<Session>(connect, readFirmware, std::make_shared<SteadyClock>()));
}

}  // namespace handwheel::falcon
