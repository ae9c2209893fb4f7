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

// The size of a line of the protocol, in either direction. A line is ASCII text: numbers separated by blanks, then
// padding blanks and a line feed. The device writes another line feed between its numbers and the padding. This is the
// maker's version of 2021-03-23; the lines of the previous version had 63 bytes.
inline constexpr std::size_t kLineSize = 64;  // bytes, its end included
using Line = std::array<std::uint8_t, kLineSize>;

// A reading from one line of the device, in its own frame.
struct Reading {
  Vec3 position = Vec3::Zero();    // mm
  std::array<double, 4> angles{};  // tA, lambda, tD, tE, rad: angles of the mechanism that holds the pen

  // Returns the pen's orientation: rotations about z by tA, about y by -lambda, about x by tD and about y by tE,
  // multiplied in this order.
  Eigen::Quaterniond orientation() const;
};

// Returns the line that commands a force, given in the device's own frame, N. The line contains the force in mN and
// command 2.
Line forceLine(const Vec3& force);

// Parses a line from the device. Returns nothing if the line does not consist of eight numbers in the columns that the
// device writes, or if its position is out of the device's reach.
std::optional<Reading> parseLine(std::string_view line);

// Assembles lines from a byte stream in pieces of any size. A line that lost some of its bytes is shorter than any
// complete line, and is skipped.
class LineReader {
 public:
  // Adds bytes and returns the number of readings that they completed. reading() returns the last of them.
  int take(std::span<const std::uint8_t> bytes);
  const Reading& reading() const { return m_reading; }

 private:
  std::array<std::uint8_t, 80> m_line{};
  std::size_t m_filled = 0;
  bool m_tooLong = false;
  Reading m_reading;
};

}  // namespace handwheel::polhem
