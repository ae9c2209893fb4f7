// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ByteStream.h"

namespace handwheel {

// A USB device with two bulk pipes and a control pipe. Closed when it is destroyed.
class UsbTransport {
 public:
  virtual ~UsbTransport() = default;
  // Sends a vendor request without data. Returns false if it was refused or the device is gone.
  virtual bool control(std::uint8_t request, std::uint16_t value) noexcept = 0;
  // Makes one transfer out. Returns false if it was not taken whole.
  virtual bool write(std::span<const std::uint8_t> bytes) noexcept = 0;
  // Makes one transfer in. Returns the number of bytes, 0 if none came in time (s), or kGone.
  virtual std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept = 0;
  virtual bool isGone() const noexcept = 0;
};

}  // namespace handwheel
