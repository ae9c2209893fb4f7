// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace handwheel {

// A ring buffer of the forces of the last seconds. It is thinned to the resolution of the plot, keeping the largest of
// several values in an interval.
class ForceTrace {
 public:
  static constexpr double kSeconds = 10.0;
  static constexpr double kSpacing = 0.025;  // least time between points, s: about a pixel of the plot

  struct Point {
    double time = 0.0;   // s since the servo loop started
    double asked = 0.0;  // N
    double sent = 0.0;   // N
  };

  // Adds a point. If its time is before the last one, the servo loop was started again, and all earlier points are
  // dropped. Times that are not finite are ignored.
  void add(const Point& point);
  void clear() { m_count = 0; }

  // Returns true if the force was constant for all of kSeconds, so that the plot does not change with time.
  bool isStill() const;

  std::size_t size() const { return m_count; }
  const Point& at(std::size_t index) const { return m_ring[(m_first + index) % m_ring.size()]; }  // 0: the oldest
  const Point& last() const { return at(m_count - 1); }

 private:
  std::array<Point, 512> m_ring;  // the points; there is room for more than kSeconds / kSpacing
  std::size_t m_first = 0;
  std::size_t m_count = 0;
};

}  // namespace handwheel
