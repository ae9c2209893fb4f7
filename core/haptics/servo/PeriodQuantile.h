// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace handwheel {

// The 99th percentile of times over the last full window of ticks. Rare, far longer times are left to the passivity
// controller and the watchdog, because otherwise one lost time slice would soften every wall. The class does not
// allocate.
class PeriodQuantile {
 public:
  // resolution: the width of a bin, s. assumed: the value until a window is full, s.
  PeriodQuantile(double resolution, double assumed) : m_resolution(resolution), m_value(assumed) {}

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
