// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety/SpeedLimit.h"

#include <algorithm>

namespace handwheel {

Vec3 SpeedLimit::damping(const Vec3& velocity) const {
  const double excess = velocity.norm() - m_settings.dampingSpeed;
  if (!(excess > 0.0)) return Vec3::Zero();
  const double range = m_settings.cutSpeed - m_settings.dampingSpeed;
  const double share = range > 0.0 ? std::min(excess / range, 1.0) : 1.0;
  return -share * m_settings.speedDamping * velocity;
}

bool SpeedLimit::cuts(double speed) {
  m_isCut = m_isCut ? speed >= m_settings.dampingSpeed : speed >= m_settings.cutSpeed;
  return m_isCut;
}

}  // namespace handwheel
