// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "openhaptics/Driver.h"

#include "io/Capabilities.h"
#include "io/DeviceHostProcess.h"
#include "io/ThreadedDevice.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace handwheel::openhaptics {

// The stiffness is stated for the manufacturer's scheduler of 1 kHz. A position of one of its ticks is answered in the
// next, as in CHAI3D, whose loop only exchanges values with a callback.
double touchDamping(double stiffness, double rate) {
  return inherentDampingFor(stiffness, rate, 1.0 / rate);
}

DeviceCapabilities touchCapabilities() {
  DeviceCapabilities all;
  all.inputs = 6;
  all.buttons = 2;
  all.maxForce = 3.3;
  all.maxStiffness = 0.4;  // CHAI3D 3.3.0
  all.maxDamping = 0.004;
  all.workspaceRadius = 75.0;
  all.inherentDamping = touchDamping(all.maxStiffness, all.nominalRate);
  all.latency = 1.0 / all.nominalRate + kHandOver;
  return all;
}

Driver::Driver(std::string bridge) : m_bridge(std::move(bridge)) {}

Driver::Driver() : Driver(guardPath("openhaptics")) {}

std::vector<DeviceInfo> Driver::find() {
  std::vector<DeviceInfo> all;
  std::error_code failed;
  if (!std::filesystem::exists(m_bridge, failed)) return all;
  const char* const names = std::getenv("HANDWHEEL_OPENHAPTICS_DEVICES");
  std::istringstream list(names ? names : "");
  for (std::string name; std::getline(list, name, ':');) {
    if (!name.empty()) all.push_back({id(), name, name + " (OpenHaptics)"});
  }
  if (all.empty()) all.push_back({id(), kDefaultDevice, "Touch or Phantom (OpenHaptics)"});
  return all;
}

std::unique_ptr<Device> Driver::make(const std::string& address) {
  const std::vector<DeviceInfo> there = find();
  const auto found = std::find_if(there.begin(), there.end(), [&](const auto& one) { return one.address == address; });
  if (found == there.end()) return nullptr;
  return std::make_unique<ThreadedDevice>(guarded(m_bridge, address, touchCapabilities(), found->name));
}

}  // namespace handwheel::openhaptics
