// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace handwheel {

inline constexpr std::ptrdiff_t kGone = -1;  // the other end is gone

// Interface of a byte stream to a device: a serial port, a socket. Closed when it is destroyed.
class ByteStream {
 public:
  virtual ~ByteStream() = default;
  // Reads received bytes, waiting up to `timeout` (s) for the first. Returns their number; 0: nothing came in time;
  // kGone.
  virtual std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept = 0;
  // Writes all bytes. Returns false if the device is gone, or the other end does not accept them.
  virtual bool write(std::span<const std::uint8_t> bytes) noexcept = 0;
};

}  // namespace handwheel
