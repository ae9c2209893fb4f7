// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "example/Driver.h"

#include "example/Session.h"
#include "io/FileStream.h"
#include "io/ThreadedDevice.h"

#include <cstdlib>
#include <filesystem>

namespace handwheel {

std::vector<DeviceInfo> ExampleDriver::find() {
  const char* const path = std::getenv("HANDWHEEL_EXAMPLE_DEVICE");
  std::error_code ignored;
  if (!path || !std::filesystem::exists(path, ignored)) return {};
  return {{id(), path, "Example device"}};
}

std::unique_ptr<Device> ExampleDriver::make(const std::string& address) {
  if (address.empty()) return nullptr;
  const auto connect = [address] { return connectUnix(address); };
  return std::make_unique<ThreadedDevice>(std::make_unique<ExampleSession>(connect));
}

}  // namespace handwheel
