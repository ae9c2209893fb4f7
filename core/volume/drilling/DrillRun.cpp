// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillRun.h"

#include "volume/VolumeReader.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

DrillRun::DrillRun(SparseVolume& volume, const DrillSetup& setup)
    : m_volume(volume), m_before(volume), m_setup(setup) {}

DrillTick DrillRun::move(const Vec3& place, const Vec3& axis, double time) {
  DrillTick tick{time, place};
  if (!place.allFinite() || !axis.allFinite() || !std::isfinite(time)) return tick;
  const Vec3 from = m_place.value_or(place), way = place - from;
  const double dt = m_place ? time - m_time : 0.0;
  m_place = place;
  m_time = time;
  if (!(dt > 0.0)) return tick;
  const auto parts = static_cast<int>(std::min(1e4, 1.0 + way.norm() / m_setup.tool.diameter));
  Vec3 push = Vec3::Zero();
  for (int i = 0; i < parts; ++i) {
    const DrillMove move{from + static_cast<double>(i) / parts * way, from + (i + 1.0) / parts * way, axis,
                         m_setup.erosion};
    const DrillCut cut = drill(m_volume, m_setup.tool, move);
    tick.removed += cut.removed;
    push += cut.removed * cut.push;
    m_changed.insert(m_changed.end(), cut.changedBlocks.begin(), cut.changedBlocks.end());
  }
  const double feed = way.norm() / dt;
  const DrillLoad load = drillLoad(m_setup.material, m_setup.tool, tick.removed, dt, feed, m_setup.spindle);
  if (push.norm() > 0.0) tick.force = -load.thrust * push.normalized();
  tick.torque = -load.torque * axis;
  tick.thrust = load.thrust;
  m_removed += tick.removed;
  m_energy += 1e-3 * (-tick.force.dot(way) + load.torque * std::abs(m_setup.spindle) * dt);
  m_maxThrust = std::max(m_maxThrust, load.thrust);
  m_maxTorque = std::max(m_maxTorque, load.torque);
  if (way.dot(axis) > 0.0) {
    m_isFrontInside = false;  // on its way out nothing is broken through
  } else if (way.norm() > 0.0) {
    watchFront(place, way, time);
  }
  return tick;
}

void DrillRun::watchFront(const Vec3& place, const Vec3& way, double time) {
  const Vec3 front = place + m_setup.tool.reach() * way.normalized();
  const bool isInside = VolumeReader(m_before).depthAt(front).depth > 0.0;
  if (m_isFrontInside && !isInside && !m_breakthrough) m_breakthrough = time;
  m_isFrontInside = isInside;
}

std::vector<VoxelIndex> DrillRun::takeChangedBlocks() {
  return std::exchange(m_changed, {});
}

}  // namespace handwheel
