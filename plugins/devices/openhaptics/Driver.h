// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

namespace handwheel::openhaptics {

// Driver of the Touch and Phantom devices of 3D Systems through OpenHaptics. Only the manufacturer's library
// communicates with these devices, and it loads files into its process that are not compatible with Handwheel.
// Therefore a separate process (Guard.cpp) loads the library, if that process was built. The driver can find out
// whether a device is connected only by opening it. The manufacturer's set-up program gives each device a name. The
// environment variable HANDWHEEL_OPENHAPTICS_DEVICES lists the names, separated by colons; if it is not set, the
// manufacturer's default device is used.
class Driver final : public DeviceDriver {
 public:
  explicit Driver(std::string bridge);  // bridge: the path of the guard program
  Driver();

  std::string id() const override { return "openhaptics"; }
  std::vector<DeviceInfo> find() override;
  std::unique_ptr<Device> make(const std::string& address) override;

 private:
  std::string m_bridge;
};

inline constexpr const char* kDefaultDevice = "default";

// Returns the inherent damping, N·s/mm, of a device, computed from its stated stiffness (N/mm) and rate (Hz).
double touchDamping(double stiffness, double rate);

// Returns the capabilities of a Touch, which are reported until the device itself has been queried.
DeviceCapabilities touchCapabilities();

}  // namespace handwheel::openhaptics
