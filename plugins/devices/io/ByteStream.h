// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace handwheel {

inline constexpr std::ptrdiff_t kGone = -1;  // the other end is not there any more

// Bytes to and from a device: a serial line, a socket. Closed when it is destroyed.
class ByteStream {
 public:
  virtual ~ByteStream() = default;
  // What has come, waiting for the first byte so many seconds at most. How many bytes; 0: nothing came in time; kGone.
  virtual std::ptrdiff_t read(std::span<std::uint8_t> into, double timeout) noexcept = 0;
  // All of them, or false: gone, or the other end does not take them.
  virtual bool write(std::span<const std::uint8_t> bytes) noexcept = 0;
};

}  // namespace handwheel
