// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace handwheel {

// The longest time that is usual: of the last full window of ticks the one that 99 of 100 do not exceed. A rare far
// longer one is for the passivity controller and the watchdog; were it to count here, one stolen time slice would
// soften every wall. Allocates nothing.
class UsualTime {
 public:
  // Times are told apart in steps of so many seconds; `assumed` (s) holds until a window is full.
  UsualTime(double resolution, double assumed) : m_resolution(resolution), m_value(assumed) {}

  void add(double seconds);
  double value() const { return m_value; }

  static constexpr std::uint32_t kWindow = 1000;  // ticks

 private:
  struct Bin {
    std::uint32_t count = 0;
    double longest = 0.0;  // s
  };
  void closeWindow();

  double m_resolution;
  double m_value;
  std::uint32_t m_count = 0;
  std::array<Bin, 256> m_bins;
};

}  // namespace handwheel
