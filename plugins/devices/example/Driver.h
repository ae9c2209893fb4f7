// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"

namespace handwheel {

// Finds the example device where the environment variable HANDWHEEL_EXAMPLE_DEVICE says that its socket is.
class ExampleDriver final : public DeviceDriver {
 public:
  std::string id() const override { return "example"; }
  std::vector<DeviceListing> find() override;
  std::unique_ptr<Device> make(const std::string& address) override;
};

}  // namespace handwheel
