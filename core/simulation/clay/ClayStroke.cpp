// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/clay/ClayStroke.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

void ClayStroke::move(const Vec3& place, double time, const Vec3& normal) {
  if (!place.allFinite() || !std::isfinite(time)) return;
  const bool isMove = m_brush.action == ClayAction::Move;
  const bool isShape = m_brush.action == ClayAction::Add || m_brush.action == ClayAction::Carve;
  const bool isStamp = isShape && m_brush.stamp, isSwept = (isShape && !isStamp) || m_brush.action == ClayAction::Mask;
  if (!m_last) {
    m_last = place;
    m_lastTime = time;
    if (!isMove) add(place, Vec3::Zero(), normal);
    return;
  }
  const Vec3 from = *m_last;
  const double length = (place - from).norm();
  if (isSwept) {
    if (length < kMoveSpacing * m_brush.radius) return;
    const double count = std::min(std::ceil(length / (kSweep * m_brush.radius)), static_cast<double>(kMostAtOnce));
    for (double i = 1.0; i <= count; ++i) {
      const Vec3 at = from + i / count * (place - from);
      add(at, at - *m_last, normal);
      m_last = at;
    }
    return;
  }
  const double spacing = (isMove ? kMoveSpacing : isStamp ? kStampSpacing : kSpacing) * m_brush.radius;
  const auto count = std::min(kMostAtOnce, static_cast<std::size_t>(std::max(0.0, length / spacing)));
  if (count == 0) {
    if (isMove || isStamp || time - m_lastTime < kRestPeriod) return;
    m_lastTime = time;
    m_last = place;
    return add(place, Vec3::Zero(), normal);
  }
  const Vec3 step = std::max(spacing, length / static_cast<double>(kMostAtOnce)) / length * (place - from);
  for (std::size_t i = 1; i <= count; ++i) {
    const Vec3 at = from + static_cast<double>(i) * step;
    add(isMove ? Vec3(at - step) : at, isMove ? step : Vec3(Vec3::Zero()), normal);
    m_last = at;
  }
  m_lastTime = time;
}

// Upright: its upper end is towards z, or towards y where the surface lies flat.
void ClayStroke::turnStamp(ClayDab& dab) const {
  constexpr double kFlat = 0.9;  // of the normal along z
  dab.stamp = m_brush.stamp;
  if (!dab.stamp) return;
  const Vec3& out = dab.direction;
  const Vec3 above = std::abs(out.z()) > kFlat ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitZ());
  const Vec3 up = (above - above.dot(out) * out).normalized(), right = up.cross(out);
  dab.up = std::cos(m_brush.turn) * up - std::sin(m_brush.turn) * right;
  dab.right = std::cos(m_brush.turn) * right + std::sin(m_brush.turn) * up;
}

void ClayStroke::add(const Vec3& centre, const Vec3& way, const Vec3& normal) {
  ClayDab dab{m_brush.action, centre, m_brush.radius, m_brush.strength, m_brush.falloff, way, Vec3::UnitZ()};
  if (!normal.isZero()) dab.direction = normal;
  turnStamp(dab);
  // A move takes all that is in its middle along.
  if (dab.action == ClayAction::Move) dab.strength = 1.0;
  // What is painted is protected entirely, or free.
  if (dab.action == ClayAction::Mask) dab.strength = std::copysign(1.0, m_brush.strength);
  std::vector<ClayDab> all{dab};
  for (int axis = 0; axis < 3; ++axis) {
    if (!m_brush.isMirrored[static_cast<std::size_t>(axis)]) continue;
    const std::size_t count = all.size();
    for (std::size_t i = 0; i < count; ++i) all.push_back(mirrored(all[i], m_brush.mirror, axis));
  }
  m_dabs.insert(m_dabs.end(), all.begin(), all.end());
}

}  // namespace handwheel
