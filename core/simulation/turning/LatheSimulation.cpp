// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/LatheSimulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

LatheSimulation::LatheSimulation(LatheRun run, TurnedSurface surface, double base,
                                 std::shared_ptr<LatheChannel> channel)
    : m_run(std::move(run)),
      m_surface(std::move(surface)),
      m_base(base),
      m_channel(std::move(channel)),
      m_now(m_run.profile(), m_surface) {
  ++m_channel->simulations;
  m_recording.setup = m_run.machine().setup();
  m_recording.start = m_run.machine().state();
  m_recording.part = std::make_shared<const TurnedProfile>(m_run.profile());
  m_recording.material = m_run.material();
  m_now.collisions = std::make_shared<const std::vector<LatheCollision>>();
  m_now.warnings = std::make_shared<const std::vector<LatheWarning>>();
  publish();
}

void LatheSimulation::takeCommands(std::span<const SimulationInput> inputs) {
  m_commands.clear();
  for (LatheCommand command; m_commands.size() < LatheChannel::kWaiting && m_channel->commands.pop(command);)
    m_commands.push_back(command);
  if (inputs.empty()) return;
  const SimulationInput& last = inputs.back();
  if (last.gesture != 0) {
    LatheCommand place;
    place.kind = LatheCommand::Kind::Place;
    place.value = last.tip.position.x();
    place.other = last.tip.position.z() - m_base;
    m_commands.push_back(place);
  } else if (m_isPlacing) {
    m_commands.push_back({LatheCommand::Kind::Release});
  }
  m_isPlacing = last.gesture != 0;
}

// Each tool makes a pass of its own. The path goes on from point to point, since each cut begins where the last move
// of the same tool ended.
void LatheSimulation::record(const LatheStep& step) {
  if (!step.tool || (!step.hasMoved() && step.cut.isEmpty())) return;
  const bool isOther =
      m_passes.empty() || m_passes.back().tool != step.tool || m_passes.back().path.back() != step.from;
  if (isOther && step.cut.isEmpty()) return;
  if (isOther) {
    TurningPass pass;
    pass.tool = step.tool;
    pass.noseRadius = std::max(step.tool->noseRadius, TurningPass::kLeastNose);
    pass.side = step.tool->side;
    pass.path.push_back(step.from);
    pass.times.push_back(0.0);
    m_begin = step.time - m_recording.dt;
    m_passes.push_back(std::move(pass));
  }
  m_passes.back().path.push_back(step.to);
  m_passes.back().times.push_back(step.time - m_begin);
}

void LatheSimulation::step(double dt, std::span<const SimulationInput> inputs) {
  takeCommands(inputs);
  m_recording.dt = dt;
  if (!m_recording.isFull()) {
    for (const LatheCommand& command : m_commands) m_recording.entries.push_back({m_recording.steps, command});
  }
  ++m_recording.steps;
  const LatheStep step = m_run.step(dt, m_commands);
  record(step);
  m_changed.extend(step.cut.changed);
  const LatheMachine& machine = m_run.machine();
  m_now.isCut = m_now.isCut || !step.cut.isEmpty();
  m_now.sinceCut = m_run.sinceCut();
  m_now.load = m_run.load();
  m_now.isHeld = step.isHeld;
  m_now.removed += step.cut.volume;
  m_now.isFull = m_recording.isFull() || (!m_passes.empty() && m_passes.back().path.size() >= TurningPass::kMostPoints);
  m_now.machine = machine.state();
  m_now.tool = m_run.tool();
  m_now.quillTip = machine.quillTip();

  LathePatch patch;
  patch.tip = machine.tip();
  patch.velocity = (patch.tip - m_now.tip) / dt;
  patch.time = inputs.empty() ? 0.0 : inputs.back().tip.time;
  patch.cut = m_now.load.cut;
  if (m_run.tool() && m_run.tool()->isAbrasive()) patch.pressed = m_now.load.forces;
  patch.wear = machine.setup().wear;
  patch.tool = static_cast<std::uint32_t>(m_run.cuttingTool());
  patch.spindleSpeed = machine.state().speed;
  patch.angle = machine.state().turns;
  m_channel->patch.write(patch);
  m_now.tip = patch.tip;

  m_sincePublished += dt;
  if (m_sincePublished * kShownRate >= 1.0) publish();
}

void LatheSimulation::publish() {
  m_sincePublished = 0.0;
  if (!m_changed.isEmpty()) m_surface.update(m_run.profile(), m_changed);
  if (!m_changed.isEmpty() || !m_now.finish) m_now.finish = std::make_shared<const SurfaceFinish>(m_run.finish());
  m_changed = {};
  m_now.profile = m_run.profile();
  m_now.surface = m_surface;
  m_now.machine = m_run.machine().state();
  m_now.tip = m_run.machine().tip();
  m_now.quillTip = m_run.machine().quillTip();
  m_now.tool = m_run.tool();
  if (m_now.collisions->size() != m_run.collisions().size())
    m_now.collisions = std::make_shared<const std::vector<LatheCollision>>(m_run.collisions());
  if (std::exchange(m_warned, m_run.warnings().changes()) != m_run.warnings().changes())
    m_now.warnings = std::make_shared<const std::vector<LatheWarning>>(m_run.warnings().all());
  m_state = std::make_shared<const LatheMoment>(m_now);
}

void LatheSimulation::finish() {
  publish();
}

}  // namespace handwheel
