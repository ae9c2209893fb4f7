// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/Device.h"

#include <string_view>

namespace handwheel::haply {

// The maker's service on this machine, on port 10001 or the one that the environment variable HANDWHEEL_HAPLY_PORT
// names.
class Driver final : public DeviceDriver {
 public:
  std::string id() const override { return "haply"; }
  std::vector<DeviceListing> find() override;
  std::unique_ptr<Device> make(const std::string& address) override;
};

// Whether the kernel's table of TCP sockets (/proc/net/tcp or tcp6) has one that listens on a port.
bool listens(std::string_view table, std::uint16_t port);

}  // namespace handwheel::haply
