// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spacemouse/Motion.h"

#include <optional>
#include <span>

namespace handwheel::spacemouse {

// Axes, buttons and battery according to the HID reports received. Any bytes are accepted; reports that SpaceMouse
// devices do not send change nothing.
class Reports {
 public:
  // Processes one report, whose first byte is its number. Returns true if the report contains values of the axes, even
  // if they are unchanged.
  bool take(std::span<const std::uint8_t> report);
  void rest() { m_counts = {}; }

  const Counts& counts() const { return m_counts; }
  std::uint32_t buttons() const { return m_buttons; }
  std::optional<int> batteryPercent() const { return m_battery; }

 private:
  bool takeMotion(std::span<const std::uint8_t> axes);
  void takeBitmap(std::span<const std::uint8_t> bitmap);
  void takeNumbers(std::span<const std::uint8_t> numbers);

  Counts m_counts;
  std::uint32_t m_buttons = 0;
  std::optional<int> m_battery;
};

}  // namespace handwheel::spacemouse
