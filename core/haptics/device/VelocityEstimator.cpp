// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/device/VelocityEstimator.h"

#include <algorithm>

namespace handwheel {

Vec3 VelocityEstimator::add(const Vec3& position, double period) {
  const double time = m_count == 0 ? 0.0 : back(0).time + period;
  m_newest = (m_newest + 1) % kCapacity;
  m_readings[m_newest] = {time, position};
  m_count = std::min(m_count + 1, kCapacity);
  std::size_t used = std::min<std::size_t>(m_count, 2);  // a window shorter than a period takes the last two
  while (used < m_count && time - back(used).time <= m_window) ++used;
  m_count = used;  // time only increases: readings that left the window stay out
  return used < 2 ? Vec3::Zero().eval() : slope(used);
}

// Times and positions are relative to the newest reading, so that neither a long run nor a distant position costs
// digits.
Vec3 VelocityEstimator::slope(std::size_t count) const {
  const Reading& origin = back(0);
  double meanTime = 0.0;
  for (std::size_t i = 0; i < count; ++i) meanTime += back(i).time - origin.time;
  meanTime /= static_cast<double>(count);
  Vec3 product = Vec3::Zero();
  double square = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = back(i).time - origin.time - meanTime;
    product += t * (back(i).position - origin.position);
    square += t * t;
  }
  return square > 0.0 ? Vec3(product / square) : Vec3::Zero();
}

}  // namespace handwheel
