// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spacemouse/SocketRecords.h"

#include "spacemouse/Buttons.h"

#include <algorithm>
#include <bit>

namespace handwheel::spacemouse {

namespace {

constexpr std::int32_t kMotionRecord = 0;
constexpr std::int32_t kPressRecord = 1;
constexpr std::int32_t kReleaseRecord = 2;

// Limits a number to a range far beyond full scale that is safe to negate.
int limited(std::int32_t value) {
  return std::clamp(value, -32767, 32767);
}

// Converts right, up, away to the order and signs of HID reports: right, towards the user, down.
std::array<int, 3> asReported(std::int32_t x, std::int32_t y, std::int32_t z) {
  return {limited(x), -limited(z), -limited(y)};
}

}  // namespace

void SocketRecords::take(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    m_partial[m_filled++] = byte;
    if (m_filled < m_partial.size()) continue;
    takeRecord(std::bit_cast<Record>(m_partial));
    m_filled = 0;
  }
}

void SocketRecords::takeRecord(const Record& record) {
  if (record[0] == kMotionRecord) {
    m_counts.translation = asReported(record[1], record[2], record[3]);
    m_counts.rotation = asReported(record[4], record[5], record[6]);
  } else if (record[0] == kPressRecord || record[0] == kReleaseRecord) {
    if (record[1] < 0 || record[1] > 0xffff) return;
    const int bit = bitOf(static_cast<std::uint16_t>(record[1]));
    if (bit == kNoBit) return;
    const std::uint32_t mask = std::uint32_t{1} << bit;
    m_buttons = record[0] == kPressRecord ? m_buttons | mask : m_buttons & ~mask;
  }
}

}  // namespace handwheel::spacemouse
