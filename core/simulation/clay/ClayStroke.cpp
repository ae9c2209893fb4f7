// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/clay/ClayStroke.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

ClayBrush ClayBrush::at(double share) const {
  constexpr double kLeastRadius = 0.1;  // share of the set radius
  ClayBrush pressed = *this;
  // A move takes the whole middle along, and a mask protects fully or not at all.
  if (action == ClayAction::Move) pressed.strength = 1.0;
  if (action == ClayAction::Mask) pressed.strength = std::copysign(1.0, strength);
  const double force = share < 1.0 ? std::max(0.0, share) : 1.0;
  if (pressure == ClayPressure::Strength || pressure == ClayPressure::Both) pressed.strength *= force;
  if (pressure == ClayPressure::Radius || pressure == ClayPressure::Both)
    pressed.radius *= std::max(kLeastRadius, force);
  return pressed;
}

void ClayStroke::move(const Vec3& position, double time, const Vec3& normal, double pressure) {
  if (!position.allFinite() || !std::isfinite(time)) return;
  const ClayBrush brush = m_brush.at(pressure);
  const bool isMove = brush.action == ClayAction::Move || brush.action == ClayAction::Smudge;
  const bool isShape = brush.action == ClayAction::Add || brush.action == ClayAction::Carve;
  const bool isStamp = isShape && brush.stamp, isSwept = (isShape && !isStamp) || brush.action == ClayAction::Mask;
  if (!m_last) {
    m_last = position;
    m_lastTime = time;
    if (!isMove) add(brush, position, Vec3::Zero(), normal);
    return;
  }
  const Vec3 from = *m_last;
  const double length = (position - from).norm();
  if (isSwept) {
    if (length < kMoveSpacing * brush.radius) return;
    const double count = std::min(std::ceil(length / (kSweep * brush.radius)), static_cast<double>(kMostAtOnce));
    for (double i = 1.0; i <= count; ++i) {
      const Vec3 at = from + i / count * (position - from);
      add(brush, at, at - *m_last, normal);
      m_last = at;
    }
    return;
  }
  const double spacing = (isMove ? kMoveSpacing : isStamp ? kStampSpacing : kSpacing) * brush.radius;
  const auto count = std::min(kMostAtOnce, static_cast<std::size_t>(std::max(0.0, length / spacing)));
  if (count == 0) {
    if (isMove || isStamp || time - m_lastTime < kRestPeriod) return;
    m_lastTime = time;
    m_last = position;
    return add(brush, position, Vec3::Zero(), normal);
  }
  const Vec3 step = std::max(spacing, length / static_cast<double>(kMostAtOnce)) / length * (position - from);
  for (std::size_t i = 1; i <= count; ++i) {
    const Vec3 at = from + static_cast<double>(i) * step;
    add(brush, isMove ? Vec3(at - step) : at, isMove ? step : Vec3(Vec3::Zero()), normal);
    m_last = at;
  }
  m_lastTime = time;
}

// Upright: its upper end is towards z, or towards y where the surface lies flat.
void ClayStroke::turnStamp(ClayDab& dab) const {
  constexpr double kFlat = 0.9;  // normal component along z
  dab.stamp = m_brush.stamp;
  if (!dab.stamp) return;
  const Vec3& out = dab.direction;
  const Vec3 above = std::abs(out.z()) > kFlat ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitZ());
  const Vec3 up = (above - above.dot(out) * out).normalized(), right = up.cross(out);
  dab.up = std::cos(m_brush.turn) * up - std::sin(m_brush.turn) * right;
  dab.right = std::cos(m_brush.turn) * right + std::sin(m_brush.turn) * up;
}

void ClayStroke::add(const ClayBrush& brush, const Vec3& centre, const Vec3& displacement, const Vec3& normal) {
  ClayDab dab{brush.action, centre, brush.radius, brush.strength, brush.falloff, displacement, Vec3::UnitZ()};
  if (!normal.isZero()) dab.direction = normal;
  turnStamp(dab);
  std::vector<ClayDab> all{dab};
  for (int axis = 0; axis < 3; ++axis) {
    if (!brush.isMirrored[static_cast<std::size_t>(axis)]) continue;
    const std::size_t count = all.size();
    for (std::size_t i = 0; i < count; ++i) all.push_back(mirrored(all[i], brush.mirror, axis));
  }
  m_dabs.insert(m_dabs.end(), all.begin(), all.end());
}

}  // namespace handwheel
