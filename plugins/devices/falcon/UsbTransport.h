// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ByteStream.h"

namespace handwheel {

// A USB device with two bulk pipes and a control pipe. The device is closed when the object is destroyed.
class UsbTransport {
 public:
  virtual ~UsbTransport() = default;
  // Sends a vendor request without data. Returns false if the request was refused or the device is gone.
  virtual bool control(std::uint8_t request, std::uint16_t value) noexcept = 0;
  // Sends bytes in one transfer. Returns false if the device did not accept all of them.
  virtual bool write(std::span<const std::uint8_t> bytes) noexcept = 0;
  // Receives bytes in one transfer. Returns the number of bytes, 0 if no bytes came within the timeout (s), or kGone.
  virtual std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept = 0;
  virtual bool isGone() const noexcept = 0;
};

}  // namespace handwheel
