// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "falcon/UsbTransport.h"

#include <memory>
#include <string>
#include <vector>

struct libusb_context;

namespace handwheel::falcon {

// Finds and opens Falcons with libusb. An address is "bus-port.port". It stays the same while the plug stays in its
// socket.
class Usb {
 public:
  Usb();
  std::vector<std::string> find() const;
  // Claims the interface, if necessary from the kernel's serial driver. Error: Unreachable with libusb's reason.
  Result<std::unique_ptr<UsbTransport>> open(const std::string& address) const;

 private:
  std::shared_ptr<libusb_context> m_context;  // null: libusb could not start, and find() finds nothing
};

}  // namespace handwheel::falcon
