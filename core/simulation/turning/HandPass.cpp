// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/HandPass.h"

#include <algorithm>

namespace handwheel {

namespace {

// Where a straight way comes nearer to the axis than both of its ends, as a share of it; none: nowhere.
std::optional<double> nearestToAxis(const Vec3& from, const Vec3& to) {
  const Eigen::Vector2d way = (to - from).head<2>();
  const double share = -from.head<2>().dot(way) / way.squaredNorm();
  return share > 0.0 && share < 1.0 ? std::optional(share) : std::nullopt;  // NaN: it goes along the axis
}

}  // namespace

// Places of a hand that passes the axis are on both sides of it: what is cut goes through it, not from radius to
// radius.
std::size_t HandPass::add(const Vec3& place, double time, double speed) {
  const std::size_t before = m_pass.path.size();
  if (const auto share = before == 0 ? std::nullopt : nearestToAxis(m_place, place))
    addPoint(m_place + *share * (place - m_place), m_time + *share * (time - m_time), speed);
  addPoint(place, time, speed);
  m_place = place;
  m_time = time;
  return m_pass.path.size() - before;
}

void HandPass::addPoint(const Vec3& place, double time, double speed) {
  if (isFull()) return;
  if (m_pass.path.empty()) m_begin = time;
  m_pass.times.push_back(std::max(time - m_begin, m_pass.times.empty() ? 0.0 : m_pass.times.back()));
  m_pass.path.emplace_back(place.head<2>().norm(), place.z() - m_base);
  if (speed > 0.0) m_pass.speeds.push_back(speed);
}

}  // namespace handwheel
