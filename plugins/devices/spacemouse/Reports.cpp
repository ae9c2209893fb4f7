// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spacemouse/Reports.h"

#include "spacemouse/Buttons.h"

namespace handwheel::spacemouse {

namespace {

constexpr std::uint8_t kMotion = 1;  // three axes, or six: determined by the length, not by the product
constexpr std::uint8_t kRotation = 2;
constexpr std::uint8_t kBitmap = 3;
constexpr std::uint8_t kBattery = 0x17;
constexpr std::uint8_t kNumbers = 0x1c;  // 0x1d is the same for long presses, which the program times itself
constexpr std::size_t kThreeAxes = 6;    // bytes after the number
constexpr std::size_t kSixAxes = 12;

int signed16(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::int16_t>(bytes[at] | bytes[at + 1] << 8);
}

std::array<int, 3> three(std::span<const std::uint8_t> axes) {
  return {signed16(axes, 0), signed16(axes, 2), signed16(axes, 4)};
}

}  // namespace

bool Reports::take(std::span<const std::uint8_t> report) {
  if (report.empty()) return false;
  const std::span<const std::uint8_t> content = report.subspan(1);
  switch (report[0]) {
    case kMotion:
      return takeMotion(content);
    case kRotation:
      if (content.size() < kThreeAxes) return false;
      m_counts.rotation = three(content);
      return true;
    case kBitmap:
      takeBitmap(content);
      return false;
    case kBattery:
      if (!content.empty() && content[0] <= 100) m_battery = content[0];
      return false;
    case kNumbers:
      takeNumbers(content);
      return false;
    default:
      return false;
  }
}

bool Reports::takeMotion(std::span<const std::uint8_t> axes) {
  if (axes.size() < kThreeAxes) return false;
  m_counts.translation = three(axes);
  if (axes.size() >= kSixAxes) m_counts.rotation = three(axes.subspan(kThreeAxes));
  return true;
}

// Bit n of byte k is button 8k + n, for reports of any length.
void Reports::takeBitmap(std::span<const std::uint8_t> bitmap) {
  if (bitmap.empty()) return;
  m_buttons = 0;
  for (std::size_t k = 0; k < bitmap.size() && k < 4; ++k) m_buttons |= std::uint32_t{bitmap[k]} << (8 * k);
}

// The numbers of the buttons that are held. 0 is an empty entry; it is not known whether it can also mean the menu
// button, number 0 in the bitmap.
void Reports::takeNumbers(std::span<const std::uint8_t> numbers) {
  m_buttons = 0;
  for (std::size_t at = 0; at + 1 < numbers.size(); at += 2) {
    const auto number = static_cast<std::uint16_t>(numbers[at] | numbers[at + 1] << 8);
    const int bit = number == 0 ? kNoBit : bitOf(number);
    if (bit != kNoBit) m_buttons |= std::uint32_t{1} << bit;
  }
}

}  // namespace handwheel::spacemouse
