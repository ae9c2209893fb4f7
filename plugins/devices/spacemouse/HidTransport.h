// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ByteStream.h"

namespace handwheel {

// Interface to send and receive the reports of a HID device. Each read returns one complete report, and each write
// sends one.
class HidTransport {
 public:
  virtual ~HidTransport() = default;
  // Reads a report, whose first byte is its number. Returns the length of the report, 0 if none arrived within the
  // timeout, or kGone if the device is gone.
  virtual std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept = 0;
  virtual bool write(std::span<const std::uint8_t> report) noexcept = 0;
};

}  // namespace handwheel
