// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/device/Device.h"

#include <string_view>

namespace handwheel::haply {

// Driver of Haply devices that uses the manufacturer's service on this machine. The port of the service is 10001, or
// the value of the environment variable HANDWHEEL_HAPLY_PORT.
class Driver final : public DeviceDriver {
 public:
  std::string id() const override { return "haply"; }
  std::vector<DeviceInfo> find() override;
  std::unique_ptr<Device> make(const std::string& address) override;
};

// Returns true if a TCP socket listens on a port. table: the content of the kernel's table of sockets (/proc/net/tcp or
// tcp6).
bool listens(std::string_view table, std::uint16_t port);

}  // namespace handwheel::haply
