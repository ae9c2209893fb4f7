// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace handwheel {

// Limits on the unpacked size of an archive. An archive of a few kilobytes can announce and contain gigabytes.
struct UnpackLimits {
  std::uint64_t largest = 0;    // bytes of all entries together, for any archive
  std::uint64_t allowance = 0;  // bytes that even the smallest archive may unpack to
  std::uint64_t ratio = 100;    // further bytes that may be unpacked per byte of the archive
  std::size_t entries = 100'000;

  std::uint64_t budget(std::uint64_t archiveBytes) const {
    // This cannot overflow, because an archive in memory is smaller than 2^57 bytes.
    return std::min(largest, allowance + ratio * archiveBytes);
  }
};

}  // namespace handwheel
