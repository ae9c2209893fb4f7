// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

namespace handwheel::openhaptics {

// Driver of the Touch and Phantom devices of 3D Systems, by OpenHaptics. Only the manufacturer's library communicates
// with them, and it brings files into a process that are not compatible with ours: a separate process loads it
// (Guard.cpp), if that was built. The driver learns whether a device is connected only by opening it; the
// manufacturer's set-up gives it a name. HANDWHEEL_OPENHAPTICS_DEVICES has names, separated by colons; without it there
// is the one that the manufacturer calls the default.
class Driver final : public DeviceDriver {
 public:
  explicit Driver(std::string bridge);  // path of the program
  Driver();

  std::string id() const override { return "openhaptics"; }
  std::vector<DeviceInfo> find() override;
  std::unique_ptr<Device> make(const std::string& address) override;

 private:
  std::string m_bridge;
};

inline constexpr const char* kDefaultDevice = "default";

// Returns the inherent damping, N·s/mm, for the stiffness (N/mm) and the rate (Hz) that are stated for a device.
double touchDamping(double stiffness, double rate);

// Returns the capabilities of a Touch, until the device itself was queried.
DeviceCapabilities touchCapabilities();

}  // namespace handwheel::openhaptics
