// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/HandPass.h"

#include <algorithm>

namespace handwheel {

namespace {

// Returns the parameter at which a straight displacement is nearer to the axis than at both ends; none: it is not.
std::optional<double> nearestToAxis(const Vec3& from, const Vec3& to) {
  const Eigen::Vector2d displacement = (to - from).head<2>();
  const double share = -from.head<2>().dot(displacement) / displacement.squaredNorm();
  return share > 0.0 && share < 1.0 ? std::optional(share) : std::nullopt;  // NaN: it goes along the axis
}

}  // namespace

// Positions of a hand that passes the axis are on both sides of it: the cut goes through it, not from radius to radius.
std::size_t HandPass::add(const Vec3& position, double time, double speed) {
  const std::size_t before = m_pass.path.size();
  if (const auto share = before == 0 ? std::nullopt : nearestToAxis(m_position, position))
    addPoint(m_position + *share * (position - m_position), m_time + *share * (time - m_time), speed);
  addPoint(position, time, speed);
  m_position = position;
  m_time = time;
  return m_pass.path.size() - before;
}

void HandPass::addPoint(const Vec3& position, double time, double speed) {
  if (isFull()) return;
  if (m_pass.path.empty()) m_begin = time;
  m_pass.times.push_back(std::max(time - m_begin, m_pass.times.empty() ? 0.0 : m_pass.times.back()));
  m_pass.path.emplace_back(position.head<2>().norm(), position.z() - m_base);
  if (speed > 0.0) m_pass.speeds.push_back(speed);
}

}  // namespace handwheel
