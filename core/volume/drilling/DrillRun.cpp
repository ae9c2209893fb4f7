// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillRun.h"

#include "volume/HybridPart.h"
#include "volume/VolumeSampler.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

DrillRun::DrillRun(SparseVolume& volume, const DrillSetup& setup)
    : m_volume(volume), m_before(volume), m_setup(setup) {}

DrillRun::DrillRun(HybridPart& part, const DrillSetup& setup) : m_volume(part.left()), m_part(&part), m_setup(setup) {}

DrillCut DrillRun::cut(const DrillMove& move) {
  if (!m_part) return drill(m_volume, m_setup.tool, move);
  m_part->make(cubesOfMove(m_volume, m_part->extent(), HybridPart::kTile, m_setup.tool, move));
  DrillCut done = drill(m_volume, m_setup.tool, move);
  m_part->keep(done.changedBlocks);
  return done;
}

double DrillRun::depthBefore(const Vec3& position) const {
  return m_part ? m_part->depthBefore(position) : VolumeSampler(m_before).depthAt(position).depth;
}

DrillTick DrillRun::move(const Vec3& position, const Vec3& axis, double time) {
  DrillTick tick{time, position};
  if (!position.allFinite() || !axis.allFinite() || !std::isfinite(time)) return tick;
  tick.ahead = aheadOf(axis, Vec3::Zero(), false);
  const Vec3 from = m_position.value_or(position), displacement = position - from;
  const double dt = m_position ? time - m_time : 0.0;
  m_position = position;
  m_time = time;
  if (!(dt > 0.0)) return tick;
  const auto parts = static_cast<int>(std::min(1e4, 1.0 + displacement.norm() / m_setup.tool.diameter));
  Vec3 push = Vec3::Zero();
  for (int i = 0; i < parts; ++i) {
    const DrillMove move{from + static_cast<double>(i) / parts * displacement, from + (i + 1.0) / parts * displacement,
                         axis, m_setup.erosion};
    const DrillCut taken = cut(move);
    tick.removed += taken.removed;
    push += taken.removed * taken.push;
    m_changed.insert(m_changed.end(), taken.changedBlocks.begin(), taken.changedBlocks.end());
  }
  const double feed = displacement.norm() / dt;
  const DrillLoad load = drillLoad(m_setup.material, m_setup.tool, tick.removed, dt, feed, m_setup.spindle);
  if (push.norm() > 0.0) tick.force = -load.thrust * push.normalized();
  tick.torque = -std::copysign(load.torque, m_setup.spindle) * axis;
  tick.thrust = load.thrust;
  m_removed += tick.removed;
  m_energy -= 1e-3 * (tick.force.dot(displacement) + tick.torque.dot(m_setup.spindle * axis) * dt);
  m_maxThrust = std::max(m_maxThrust, load.thrust);
  m_maxTorque = std::max(m_maxTorque, load.torque);
  tick.ahead = aheadOf(axis, displacement, tick.removed > 0.0);
  watchTip(tick.ahead, displacement.norm(), time);
  return tick;
}

Vec3 DrillRun::aheadOf(const Vec3& axis, const Vec3& displacement, bool isCutting) {
  if (m_setup.tool.shape != DrillShape::Saw) return -axis;
  const Vec3 across = displacement - displacement.dot(axis) * axis;
  if (isCutting && !m_ahead && across.norm() > 1e-6 * displacement.norm()) m_ahead = across.normalized();
  return m_ahead.value_or(-axis);
}

// A hand trembles, so the position of the tip counts, not the motion of this cycle. A tip that has come out on the
// other side has material behind it; one that is drawn back, or slips over the surface, has none.
void DrillRun::watchTip(const Vec3& ahead, double travel, double time) {
  if (m_breakthrough || (m_setup.tool.shape == DrillShape::Saw && !m_ahead)) return;
  const Vec3 tip = *m_position + m_setup.tool.edge() * ahead;
  const auto isInside = [&](double behind) { return depthBefore(tip - behind * ahead) > 0.0; };
  const bool wasInside = std::exchange(m_isTipInside, isInside(0.0));
  if (!wasInside || m_isTipInside) return;
  const int steps = static_cast<int>(std::min(1e4, std::ceil(travel / m_volume.voxel()))) + 1;
  for (int i = 1; i <= steps && !m_breakthrough; ++i)
    if (isInside(i * m_volume.voxel())) m_breakthrough = time;
}

std::vector<VoxelIndex> DrillRun::takeChangedBlocks() {
  return std::exchange(m_changed, {});
}

}  // namespace handwheel
