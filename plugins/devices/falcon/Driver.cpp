// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "falcon/Driver.h"

#include "falcon/Session.h"
#include "io/DeviceHostProcess.h"
#include "io/ThreadedDevice.h"

#include <algorithm>

namespace handwheel::falcon {

std::vector<DeviceInfo> Driver::find() {
  std::vector<DeviceInfo> all;
  for (std::string& address : m_usb.find()) all.push_back({id(), std::move(address), "Novint Falcon"});
  return all;
}

std::unique_ptr<Device> Driver::make(const std::string& address) {
  const std::vector<std::string> there = m_usb.find();
  if (std::find(there.begin(), there.end(), address) == there.end()) return nullptr;
  const DeviceCapabilities kind = Session({}, {}, {}).capabilities();
  return std::make_unique<ThreadedDevice>(guarded(guardPath(id()), address, kind, "Novint Falcon"));
}

}  // namespace handwheel::falcon
