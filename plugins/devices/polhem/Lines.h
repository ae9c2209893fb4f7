// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace handwheel::polhem {

// Both directions speak ASCII: numbers between blanks, filled up with blanks, ended by a line feed.
inline constexpr std::size_t kLineSize = 63;  // bytes of a line to the device, its end included
using Line = std::array<std::uint8_t, kLineSize>;

// What the device says in each line, in its own frame.
struct Reading {
  Vec3 position = Vec3::Zero();    // mm
  std::array<double, 4> angles{};  // tA, lambda, tD, tE, rad: of the mechanism that holds the pen

  // The pen's orientation: about z by tA, about y by -lambda, about x by tD, about y by tE, one after the other.
  Eigen::Quaterniond orientation() const;
};

// A force in the device's own frame, N: sent as mN, as command 2 takes them.
Line forceLine(const Vec3& force);

// Nothing when it is not eight numbers in the columns that the device writes, or when it cannot be a place of this
// device.
std::optional<Reading> parseLine(std::string_view line);

// Puts lines together from pieces of any size. A line that lost some of its bytes is shorter than any whole one, and
// passed over.
class LineReader {
 public:
  // How many readings these bytes completed; reading() is the last.
  int take(std::span<const std::uint8_t> bytes);
  const Reading& reading() const { return m_reading; }

 private:
  std::array<std::uint8_t, 80> m_line{};
  std::size_t m_filled = 0;
  bool m_tooLong = false;
  Reading m_reading;
};

}  // namespace handwheel::polhem
