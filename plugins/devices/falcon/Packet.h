// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "falcon/Kinematics.h"

#include <cstdint>
#include <span>

namespace handwheel::falcon {

inline constexpr std::size_t kPacketSize = 16;
using PacketBytes = std::array<std::uint8_t, kPacketSize>;

// Bits of the byte that the host sends after the torques: lights and homing.
enum Light : std::uint8_t { kHoming = 1, kGreen = 2, kBlue = 4, kRed = 8 };

// Encodes a packet to the device. It consists of "<", three signed 16-bit torques by nibbles, lowest first, the lights,
// "A" and ">". Each nibble is encoded as 'A' plus its value.
PacketBytes encode(const Counts& torques, std::uint8_t lights);

// One reading from the device.
struct Reading {
  Counts encoders{};
  std::uint8_t buttons = 0;  // bits of the buttons: plus, forward, centre, minus
  std::uint8_t homed = 0;    // bits 0…2: arms that know their position

  bool isHomed() const { return homed == 7; }
};

// Parses the device's answers from a byte stream that may have lost bytes. An answer begins with "<", ends with ">" 15
// bytes later, and contains only nibbles for the encoders. Bytes that belong to no answer are skipped.
class AnswerReader {
 public:
  // Adds bytes, and returns the number of answers that they completed. reading() returns the last one.
  int take(std::span<const std::uint8_t> bytes);
  void clear() { m_filled = 0; }
  const Reading& reading() const { return m_reading; }

 private:
  void dropToNextStart();

  PacketBytes m_partial{};
  std::size_t m_filled = 0;
  Reading m_reading;
};

}  // namespace handwheel::falcon
