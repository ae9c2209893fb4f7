// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/ByteStream.h"

namespace handwheel {

// Interface to send and receive the reports of a HID device. Each read gives one whole report, each write takes one.
class HidTransport {
 public:
  virtual ~HidTransport() = default;
  // Reads a report, its number first. Returns its length; 0: none came in time; kGone.
  virtual std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept = 0;
  virtual bool write(std::span<const std::uint8_t> report) noexcept = 0;
};

}  // namespace handwheel
