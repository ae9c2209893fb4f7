// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/drilling/DrillSimulation.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

std::shared_ptr<const DrillState> beginning(const ClayState& begin) {
  auto state = std::make_shared<DrillState>();
  state->volume = begin.volume;
  state->surface = begin.surface;
  return state;
}

}  // namespace

DrillSimulation::DrillSimulation(std::shared_ptr<const ClayState> begin, const DrillSetup& setup,
                                 std::optional<DrillFeed> feed, std::shared_ptr<ClayChannel> channel)
    : m_state(beginning(*begin)),
      m_volume(begin->volume),
      m_run(m_volume, setup),
      m_feed(feed),
      m_channel(std::move(channel)) {}

void DrillSimulation::step(double dt, std::span<const SimulationInput> inputs) {
  m_load = {};
  m_hasTicks = false;
  for (const SimulationInput& input : inputs) {
    if (input.gesture == 0) continue;
    if (m_feed) {
      if (!m_start && input.proxy.allFinite()) m_start = input.proxy;
      continue;
    }
    if (!m_begin) m_begin = input.tip.time;
    m_time = input.tip.time - *m_begin;
    add(m_run.move(input.proxy, input.tip.orientation * Vec3::UnitZ(), m_time));
  }
  if (m_start) advance(dt);
  if (m_hasTicks) publish();
  if (m_isWritten) return;
  m_channel->patch.write({m_state});
  m_isWritten = true;
}

void DrillSimulation::advance(double dt) {
  add(m_run.move(*m_start - m_feed->speed * m_time * m_feed->axis, m_feed->axis, m_time));
  m_time += dt;
}

void DrillSimulation::add(const DrillTick& tick) {
  m_load.thrust = std::max(m_load.thrust, tick.thrust);
  m_load.torque = std::max(m_load.torque, tick.torque.norm());
  m_hasTicks = true;
}

void DrillSimulation::publish() {
  const std::vector<VoxelIndex> changed = m_run.takeChangedBlocks();
  for (const VoxelIndex& block : changed) m_changed.insert({block.x(), block.y(), block.z()});
  auto state = std::make_shared<DrillState>(*m_state);
  state->volume = m_volume;
  state->surface.update(m_volume, changed);
  state->changedBlocks = m_changed.size();
  state->thrust = m_load.thrust;
  state->torque = m_load.torque;
  state->maxThrust = m_run.maxThrust();
  state->maxTorque = m_run.maxTorque();
  state->removed = m_run.removed();
  state->energy = m_run.energy();
  state->time = m_time;
  state->breakthrough = m_run.breakthrough();
  m_state = std::move(state);
  m_isWritten = false;
}

}  // namespace handwheel
