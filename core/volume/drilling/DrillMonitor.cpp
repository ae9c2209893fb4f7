// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillMonitor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

double DrillHeat::volume(const DrillBit& tool) {
  if (tool.shape == DrillShape::Saw)
    return 0.5 * M_PI * tool.width * (std::pow(tool.radius() + kLayer, 2) - std::pow(tool.radius(), 2));
  return 2.0 * M_PI / 3.0 * (std::pow(tool.radius() + kLayer, 3) - std::pow(tool.radius(), 3));
}

void DrillMonitor::beginHole(const DrillSetup& setup) {
  m_begin += m_time;
  m_time = 0.0;
  m_setup = setup;
  m_position.reset();
  m_last.clear();
  m_contact.reset();
  m_exit.reset();
  m_temperature = 0.0;
}

double DrillMonitor::deviation(const Vec3& p) const {
  const Vec3 from = p - m_plan.entry;
  return (from - from.dot(m_plan.direction) * m_plan.direction).norm();
}

double DrillMonitor::forbiddenDepth(const Vec3& centre, const Vec3& axis) const {
  double deepest = -std::numeric_limits<double>::infinity();
  for (const SolidBall& ball : m_plan.forbidden)
    deepest = std::max(deepest, ball.radius + m_setup.tool.signedDepth(ball.centre - centre, axis));
  return deepest;
}

DrillMoment DrillMonitor::add(const DrillTick& tick, const Vec3& axis, bool isThrough) {
  const double dt = m_position ? tick.time - m_time : 0.0;
  DrillMoment moment;
  moment.time = m_begin + tick.time;
  takeMeans(moment, tick, dt);
  if (dt > 0.0) {
    const double power = 1e-3 * tick.torque.norm() * std::abs(m_setup.spindle);  // W
    const double warming = DrillHeat::kShare * power / (DrillHeat::kHeat * DrillHeat::volume(m_setup.tool));
    m_temperature = m_temperature * std::exp(-dt / DrillHeat::kTime) + warming * dt;
  }
  const Vec3 tip = tick.position + m_setup.tool.edge() * tick.ahead;
  moment.temperature = m_temperature;
  moment.depth = (tip - m_plan.entry).dot(m_plan.direction);
  if (tick.removed > 0.0 && !m_contact) m_contact = tip;
  moment.holeDepth = m_contact ? (tip - *m_contact).dot(tick.ahead) : 0.0;
  moment.deviation = std::max(deviation(tick.position), deviation(tip));
  moment.forbidden = forbiddenDepth(tick.position, axis);
  moment.isCutting = tick.removed > 0.0;
  moment.isThrough = isThrough;
  m_position = tick.position;
  m_time = tick.time;
  count(moment, tip, tick.ahead);
  return moment;
}

// Summed again each time, so that no rounding errors of past loads remain.
void DrillMonitor::takeMeans(DrillMoment& moment, const DrillTick& tick, double dt) {
  if (!(dt > 0.0)) return;
  m_last.push_back({dt, (tick.position - *m_position).norm(), dt * tick.thrust, dt * tick.torque.norm()});
  Passage sum{};
  auto first = m_last.end();
  while (first != m_last.begin() && sum.seconds < DrillMoment::kMeanTime) {
    --first;
    sum.seconds += first->seconds;
    sum.travel += first->travel;
    sum.impulse += first->impulse;
    sum.angular += first->angular;
  }
  m_last.erase(m_last.begin(), first);
  const double seconds = std::max(sum.seconds, DrillMoment::kMeanTime);
  moment.thrust = sum.impulse / seconds;
  moment.torque = sum.angular / seconds;
  moment.feed = sum.travel / seconds;
}

void DrillMonitor::count(const DrillMoment& moment, const Vec3& tip, const Vec3& ahead) {
  DrillStatistics& f = m_figures;
  if (moment.isCutting && !f.contact) f.contact = moment.time;
  if (moment.isThrough && !f.breakthrough) f.breakthrough = moment.time;
  if (moment.isThrough && !m_exit) m_exit = tip;
  if (moment.isCutting) f.deviation = std::max(f.deviation, moment.deviation);
  if (m_exit) f.plunge = std::max(f.plunge, (tip - *m_exit).dot(ahead));
  f.forbidden = std::max(f.forbidden, moment.forbidden);
  f.thrust = std::max(f.thrust, moment.thrust);
  f.torque = std::max(f.torque, moment.torque);
  f.temperature = std::max(f.temperature, moment.temperature);
  f.end = moment.time;
}

}  // namespace handwheel
