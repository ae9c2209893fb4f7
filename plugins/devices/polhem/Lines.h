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

// The size of a line of the protocol, in either direction. Lines are ASCII: numbers between blanks, padded with blanks,
// ended by a line feed. The device ends its numbers with another line feed, before the blanks. The maker's version of
// 2021-03-23; the one before had 63 bytes.
inline constexpr std::size_t kLineSize = 64;  // bytes, its end included
using Line = std::array<std::uint8_t, kLineSize>;

// A reading from one line of the device, in its own frame.
struct Reading {
  Vec3 position = Vec3::Zero();    // mm
  std::array<double, 4> angles{};  // tA, lambda, tD, tE, rad: angles of the mechanism that holds the pen

  // Returns the pen's orientation: about z by tA, about y by -lambda, about x by tD, about y by tE, one after the
  // other.
  Eigen::Quaterniond orientation() const;
};

// Returns the line for a force in the device's own frame, N. Sent as mN by command 2.
Line forceLine(const Vec3& force);

// Parses a line from the device. Nothing when it is not eight numbers in the columns that the device writes, or when it
// cannot be a position of this device.
std::optional<Reading> parseLine(std::string_view line);

// Assembles lines from a byte stream in pieces of any size. A line that lost some of its bytes is shorter than any
// whole one, and skipped.
class LineReader {
 public:
  // Adds bytes; returns how many readings they completed. reading() is the last.
  int take(std::span<const std::uint8_t> bytes);
  const Reading& reading() const { return m_reading; }

 private:
  std::array<std::uint8_t, 80> m_line{};
  std::size_t m_filled = 0;
  bool m_tooLong = false;
  Reading m_reading;
};

}  // namespace handwheel::polhem
