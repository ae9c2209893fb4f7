// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace handwheel {

inline constexpr std::ptrdiff_t kGone = -1;  // the other end is gone

// Interface of a byte stream to a device: a serial port, a socket. The stream is closed when the object is destroyed.
class ByteStream {
 public:
  virtual ~ByteStream() = default;
  // Reads received bytes, waiting up to `timeout` (s) for the first. Returns the number of bytes, 0 if no bytes came in
  // time, or kGone.
  virtual std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept = 0;
  // Writes all bytes. Returns false if the other end is gone or does not accept them.
  virtual bool write(std::span<const std::uint8_t> bytes) noexcept = 0;
};

}  // namespace handwheel
