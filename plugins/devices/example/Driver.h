// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

namespace handwheel {

// Driver of the example device. The environment variable HANDWHEEL_EXAMPLE_DEVICE contains the path of the device's
// socket.
class ExampleDriver final : public DeviceDriver {
 public:
  std::string id() const override { return "example"; }
  std::vector<DeviceInfo> find() override;
  std::unique_ptr<Device> make(const std::string& address) override;
};

}  // namespace handwheel
