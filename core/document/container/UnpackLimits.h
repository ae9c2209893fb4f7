// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace handwheel {

// Limits on the unpacked size of an archive. A ZIP of a few kilobytes can announce, and deliver, gigabytes.
struct UnpackLimits {
  std::uint64_t largest = 0;    // bytes of all entries together, for any archive
  std::uint64_t allowance = 0;  // bytes that even the smallest archive may unpack to,
  std::uint64_t ratio = 100;    // plus this many per byte of the archive
  std::size_t entries = 100'000;

  std::uint64_t budget(std::uint64_t archiveBytes) const {
    // No overflow: an archive in memory is smaller than 2^57 bytes.
    return std::min(largest, allowance + ratio * archiveBytes);
  }
};

}  // namespace handwheel
