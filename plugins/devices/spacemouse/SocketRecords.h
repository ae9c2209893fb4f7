// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spacemouse/Motion.h"

#include <array>
#include <span>

namespace handwheel::spacemouse {

// Axes and buttons according to the records received from spacenavd. A record is eight 32-bit numbers in the machine's
// byte order, the first of which is the type. Records may arrive in pieces. The axes of spacenavd are x right, y up, z
// away from the user.
class SocketRecords {
 public:
  void take(std::span<const std::uint8_t> bytes);

  const Counts& counts() const { return m_counts; }
  std::uint32_t buttons() const { return m_buttons; }

 private:
  using Record = std::array<std::int32_t, 8>;
  void takeRecord(const Record& record);

  std::array<std::uint8_t, sizeof(Record)> m_partial{};
  std::size_t m_filled = 0;
  Counts m_counts;
  std::uint32_t m_buttons = 0;
};

}  // namespace handwheel::spacemouse
