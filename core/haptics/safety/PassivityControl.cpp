// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety/PassivityControl.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

PassivityControl::PassivityControl(const SafetySettings& settings) : m_settings(settings) {
  // One tick and the fraction of another are kept beyond the whole ones.
  const double ticks = std::clamp(settings.latency / settings.nominalPeriod, 0.0, static_cast<double>(kLongest - 2));
  m_latency = static_cast<std::size_t>(ticks);
  m_latencyShare = ticks - std::floor(ticks);
  m_sent.fill(Vec3::Zero());
  m_friction.fill(0.0);
}

void PassivityControl::sent(const Vec3& force) {
  m_newest = (m_newest + 1) % kLongest;
  m_sent[m_newest] = force;
  m_friction[m_newest] = 0.0;
}

void PassivityControl::observe(const Vec3& position, double period) {
  if (m_hasPosition) {
    const Vec3 step = position - m_position;
    const double friction = m_settings.inherentDamping * step.squaredNorm() / period;
    m_friction[m_newest] = friction;
    const Vec3 force = acting();
    m_energy += -force.dot(step) + friction;
    // In free space the only credit is the friction since then: it pays for entering a wall, which a force of this
    // latency answers that late. In contact there is a cap, so that long sliding does not hide later energy.
    m_energy = std::min(m_energy, force.isZero(0.0) ? recentFriction() : m_settings.energyLimit);
    m_velocity = step / period;
  }
  m_position = position;
  m_hasPosition = true;
}

// Returns the mean force over the last period: the older force until the newer one arrived.
Vec3 PassivityControl::acting() const {
  if (m_latencyShare == 0.0) return sentBefore(m_latency);
  return m_latencyShare * sentBefore(m_latency + 1) + (1.0 - m_latencyShare) * sentBefore(m_latency);
}

double PassivityControl::recentFriction() const {
  const std::size_t last = m_latencyShare == 0.0 ? m_latency : m_latency + 1;
  double sum = 0.0;
  for (std::size_t i = 0; i <= last; ++i) sum += m_friction[(m_newest + kLongest - i) % kLongest];
  return sum;
}

Vec3 PassivityControl::correction() const {
  // mm²/s: that of a damping of 1 in one period
  const double power = m_velocity.squaredNorm() * m_settings.nominalPeriod;
  if (m_energy >= 0.0 || power == 0.0) return Vec3::Zero();
  const double damping = std::min(-m_energy / power, m_settings.controlDamping);
  return -damping * m_velocity;
}

}  // namespace handwheel
