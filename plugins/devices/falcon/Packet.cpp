// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "falcon/Packet.h"

#include <algorithm>

namespace handwheel::falcon {

namespace {

constexpr std::uint8_t kStart = '<';
constexpr std::uint8_t kEnd = '>';
constexpr std::uint8_t kZero = 'A';
constexpr std::size_t kStatusAt = 13;

bool isNibble(std::uint8_t byte) {
  return byte >= kZero && byte < kZero + 16;
}

bool isAnswer(const PacketBytes& packet) {
  return packet.front() == kStart && packet.back() == kEnd &&
         std::all_of(packet.begin() + 1, packet.begin() + kStatusAt, isNibble) && packet[kStatusAt] >= kZero;
}

int signed16(const PacketBytes& packet, std::size_t at) {
  int value = 0;
  for (std::size_t i = 0; i < 4; ++i) value |= (packet[at + i] - kZero) << (4 * i);
  return static_cast<std::int16_t>(value);
}

Reading decode(const PacketBytes& packet) {
  Reading reading;
  for (std::size_t i = 0; i < 3; ++i) reading.encoders[i] = signed16(packet, 1 + 4 * i);
  const int status = packet[kStatusAt] - kZero;
  reading.buttons = static_cast<std::uint8_t>(status & 15);
  reading.homed = static_cast<std::uint8_t>(status >> 4 & 7);
  return reading;
}

}  // namespace

PacketBytes encode(const Counts& torques, std::uint8_t lights) {
  PacketBytes packet{};
  packet.fill(kZero);
  packet.front() = kStart;
  packet.back() = kEnd;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto bits = static_cast<std::uint16_t>(torques[i]);
    for (std::size_t nibble = 0; nibble < 4; ++nibble) {
      packet[1 + 4 * i + nibble] = static_cast<std::uint8_t>(kZero + (bits >> (4 * nibble) & 15));
    }
  }
  packet[kStatusAt] = static_cast<std::uint8_t>(kZero + (lights & 15));
  return packet;
}

int AnswerReader::take(std::span<const std::uint8_t> bytes) {
  int answers = 0;
  for (const std::uint8_t byte : bytes) {
    if (m_filled == 0 && byte != kStart) continue;
    m_partial[m_filled++] = byte;
    if (m_filled < kPacketSize) continue;
    if (isAnswer(m_partial)) {
      m_reading = decode(m_partial);
      m_filled = 0;
      ++answers;
    } else {
      dropToNextStart();
    }
  }
  return answers;
}

// Drops the beginning of a packet that was cut short: the next may have begun within it.
void AnswerReader::dropToNextStart() {
  const auto start = std::find(m_partial.begin() + 1, m_partial.end(), kStart);
  m_filled = static_cast<std::size_t>(std::move(start, m_partial.end(), m_partial.begin()) - m_partial.begin());
}

}  // namespace handwheel::falcon
