// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"

namespace handwheel::openhaptics {

// The devices of 3D Systems, Touch and Phantom. Only the maker's library speaks with them, and it brings files into a
// process that do not go with ours: a process of its own loads it (Guard.cpp), where somebody has built that. Whether a
// device is plugged in is known when it is opened; the maker's set-up gives it a name. HANDWHEEL_OPENHAPTICS_DEVICES
// has names, separated by colons; without it there is the one that the maker calls the default.
class Driver final : public DeviceDriver {
 public:
  explicit Driver(std::string bridge);  // the program
  Driver();

  std::string id() const override { return "openhaptics"; }
  std::vector<DeviceListing> find() override;
  std::unique_ptr<Device> make(const std::string& address) override;

 private:
  std::string m_bridge;
};

inline constexpr const char* kDefaultDevice = "default";

// Of a Touch, until the device itself was asked.
DeviceCapabilities touchCapabilities();

}  // namespace handwheel::openhaptics
