// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <array>
#include <cstddef>

namespace handwheel {

// Estimates velocity from positions by least-squares line fitting. The line is fitted to the readings of the last
// `window` seconds. The estimate is exact for motion at constant velocity with any sampling times. It lags by half the
// window. For n readings at period T with noise of standard deviation s, its standard deviation is s/T·√(12/(n(n²-1))).
// The estimator does not allocate.
class VelocityEstimator {
 public:
  // window: the duration of the window, s. If the window contains more than kCapacity readings, the newest are used.
  explicit VelocityEstimator(double window = kStandardWindow) : m_window(window) {}

  // Adds a reading, mm, `period` seconds (> 0) after the previous one. Returns the velocity, mm/s, or zero for the
  // first reading.
  Vec3 add(const Vec3& position, double period);
  void reset() { m_count = 0; }

  static constexpr double kStandardWindow = 0.01;
  // The largest servo.velocity_window needs 400 readings at the highest rate.
  static constexpr std::size_t kCapacity = 512;

 private:
  struct Reading {
    double time = 0.0;
    Vec3 position = Vec3::Zero();
  };
  const Reading& back(std::size_t i) const { return m_readings[(m_newest + kCapacity - i) % kCapacity]; }
  Vec3 slope(std::size_t count) const;

  double m_window;
  std::array<Reading, kCapacity> m_readings;
  std::size_t m_newest = 0;
  std::size_t m_count = 0;
};

}  // namespace handwheel
