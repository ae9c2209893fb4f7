// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/turning/LatheSimulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace handwheel {

namespace {

// Share of the demanded speed at which a spindle counts as constant.
constexpr double kHeld = 0.99;

// Returns true if a thread continues: its helix is the same.
bool goesOn(const TurningPass& pass, const LatheStep& step) {
  constexpr double kSame = 1e-6;  // mm
  if (!pass.thread || !step.thread) return !pass.thread && !step.thread;
  const double apart = pass.thread->offset - step.thread->offset, pitch = step.thread->pitch;
  return pass.thread->pitch == pitch && pass.thread->isLeft == step.thread->isLeft &&
         std::abs(apart - pitch * std::round(apart / pitch)) < kSame;
}

// Returns true if the last point of a path lies between the previous and the next, at the same radius.
bool isStraightOn(const std::vector<ProfilePoint>& path, const ProfilePoint& next) {
  if (path.size() < 2) return false;
  const ProfilePoint &before = path[path.size() - 2], &last = path.back();
  return before.x() == last.x() && last.x() == next.x() && (last.y() - before.y()) * (next.y() - last.y()) >= 0.0;
}

}  // namespace

LatheSimulation::LatheSimulation(LatheRun run, TurnedSurface surface, double base,
                                 std::shared_ptr<LatheChannel> channel, SurfaceFinish finish, std::size_t passesBefore)
    : m_run(std::move(run)),
      m_surface(std::move(surface)),
      m_base(base),
      m_channel(std::move(channel)),
      m_finish(m_run.profile(), std::move(finish)),
      m_passesBefore(passesBefore),
      m_number(++m_channel->simulations),
      m_now(m_run.profile(), m_surface) {
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
    if (last.gesture != m_gesture) {
      const auto isOfIt = [&](const SimulationInput& each) { return each.gesture == last.gesture; };
      m_grip = m_run.machine().tip() - handAt(*std::find_if(inputs.begin(), inputs.end(), isOfIt));
    }
    const ProfilePoint tip = handAt(last) + m_grip;
    m_commands.push_back({LatheCommand::Kind::MoveTip, LatheAxis::Carriage, tip.x(), tip.y()});
  } else if (m_gesture != 0) {
    m_commands.push_back({LatheCommand::Kind::Release});
  }
  m_gesture = last.gesture;
}

// Returns the position of a hand in the half plane of the tool.
ProfilePoint LatheSimulation::handAt(const SimulationInput& input) const {
  return {input.tip.position.x(), input.tip.position.z() - m_base};
}

// Each tool makes a pass of its own. Its path is continuous, since each cut begins where the last move of the same tool
// ended.
void LatheSimulation::record(const LatheStep& step, double dt) {
  if (!step.tool || (!step.hasMoved() && step.cut.isEmpty())) return;
  const bool isOther = m_passes.empty() || m_passes.back().tool != step.tool ||
                       m_passes.back().path.back() != step.from || !goesOn(m_passes.back(), step);
  if (isOther && step.cut.isEmpty() && !step.cutsThread()) return;
  if (isOther) {
    TurningPass pass;
    pass.tool = step.tool;
    pass.noseRadius = std::max(step.tool->noseRadius, TurningPass::kLeastNose);
    pass.side = step.tool->side;
    pass.thread = step.thread;
    pass.path.push_back(step.from);
    pass.times.push_back(0.0);
    pass.speeds.push_back(60.0 * step.turns / dt);
    m_begin = step.time - dt;
    m_passes.push_back(std::move(pass));
  }
  TurningPass& pass = m_passes.back();
  if (pass.thread && isStraightOn(pass.path, step.to)) {
    pass.path.pop_back();
    pass.times.pop_back();
    pass.speeds.pop_back();
    if (!pass.askedSpeeds.empty()) pass.askedSpeeds.pop_back();
  }
  pass.path.push_back(step.to);
  pass.times.push_back(step.time - m_begin);
  const double speed = 60.0 * step.turns / dt, asked = std::abs(m_run.machine().targetSpeed());
  const bool isSlowed = m_run.load().isCutting && speed < kHeld * asked;
  if (isSlowed && pass.askedSpeeds.empty()) pass.askedSpeeds = pass.speeds;
  pass.speeds.push_back(speed);
  if (!pass.askedSpeeds.empty()) pass.askedSpeeds.push_back(isSlowed ? asked : speed);
  if (pass.thread) m_threaded.extend(samplesBeside(step));
  m_finish.add(pass, pass.path.size() - 1, static_cast<std::uint32_t>(m_passesBefore + m_passes.size() - 1),
               m_run.profile(), step.cut.changed);
}

// Returns the samples whose triangles a step of a thread may change: with its run-out, and half a groove on both sides.
TurnedProfile::Range LatheSimulation::samplesBeside(const LatheStep& step) const {
  const auto [low, high] = std::minmax(step.from.y(), step.to.y());
  const double reach = 2.0 * step.thread->lead(), spacing = m_run.profile().spacing();
  const double last = static_cast<double>(m_run.profile().size());
  return {static_cast<std::size_t>(std::clamp((low - reach) / spacing, 0.0, last)),
          static_cast<std::size_t>(std::clamp((high + reach) / spacing, 0.0, last))};
}

// The hand is outside of the part, which is felt as it is shown: its threads do not turn. While the spindle turns they
// are felt as their envelope: no hand could follow a helix.
ProfilePatch LatheSimulation::patchAt(const SimulationInput& input) const {
  const Vec3& hand = input.tip.position;
  if (!hand.allFinite()) return {};
  PatchThreads threads;
  if (m_run.machine().state().speed == 0.0) threads = {m_surface.threads().get(), std::atan2(hand.y(), hand.x())};
  ProfilePatch patch = patchAround(m_run.profile(), hand.z() - m_base, kFinger, TurningSide::Outside, threads);
  patch.simulation = m_number;
  return patch;
}

void LatheSimulation::step(double dt, std::span<const SimulationInput> inputs) {
  takeCommands(inputs);
  const LatheStep step = m_run.step(dt, m_commands);
  record(step, dt);
  m_changed.extend(step.cut.changed);
  const LatheMachine& machine = m_run.machine();
  m_now.isCut = m_now.isCut || !step.cut.isEmpty() || step.cutsThread();
  m_now.sinceCut = m_run.sinceCut();
  m_now.load = m_run.load();
  m_now.isHeld = step.isHeld;
  m_now.removed += step.cut.volume;
  m_now.isFull = !m_passes.empty() && m_passes.back().path.size() >= TurningPass::kMostPoints;
  m_now.machine = machine.state();
  m_now.tool = m_run.tool();
  m_now.quillTip = machine.quillTip();

  LathePatch patch;
  patch.tip = machine.tip();
  patch.velocity = (patch.tip - m_now.tip) / dt;
  patch.time = inputs.empty() ? 0.0 : inputs.back().tip.time;
  patch.cut = m_now.load.cut;
  patch.passive = m_now.load.passive;
  patch.press = m_now.load.press;
  if (!patch.press.isZero(0.0)) patch.rub = m_now.load.forces.cutting;
  patch.wear = machine.setup().wear;
  patch.tool = static_cast<std::uint32_t>(m_run.cuttingTool());
  patch.spindleSpeed = machine.state().speed;
  patch.angle = machine.state().turns;
  patch.gesture = m_gesture;
  patch.grip = Vec3(m_grip.x(), 0.0, m_grip.y());
  if (!inputs.empty()) m_part = patchAt(inputs.back());
  patch.part = m_part;
  m_channel->patch.write(patch);
  m_now.tip = patch.tip;

  m_sincePublished += dt;
  m_sinceThreaded += dt;
  if (m_sincePublished * kShownRate >= 1.0) publish();
}

void LatheSimulation::publish() {
  m_sincePublished = 0.0;
  if (!m_changed.isEmpty()) m_surface.update(m_run.profile(), m_changed);
  m_changed = {};
  if (!m_threaded.isEmpty() && m_sinceThreaded * kThreadRate >= 1.0) {
    std::shared_ptr<const PartThreads> threads = m_surface.threads();
    for (; m_shownPasses < m_passes.size(); ++m_shownPasses)
      threads = PartThreads::with(threads, m_passes[m_shownPasses]);
    m_shownPasses = m_passes.size() - 1;  // the last one may go on
    m_surface.setThreads(m_run.profile(), std::move(threads), m_threaded);
    m_threaded = {};
    m_sinceThreaded = 0.0;
  }
  m_now.profile = m_run.profile();
  m_now.finish = m_finish.finish();
  m_now.surface = m_surface;
  m_now.machine = m_run.machine().state();
  m_now.tip = m_run.machine().tip();
  m_now.quillTip = m_run.machine().quillTip();
  m_now.tool = m_run.tool();
  if (m_now.collisions->size() != m_run.collisions().size()) {
    auto all = std::make_shared<std::vector<LatheCollision>>(*m_now.collisions);
    for (std::size_t i = all->size(); i < m_run.collisions().size(); ++i) {
      all->push_back(m_run.collisions()[i]);
      all->back().passes = static_cast<double>(m_passesBefore + m_passes.size());
    }
    m_now.collisions = std::move(all);
  }
  if (std::exchange(m_warned, m_run.warnings().changes()) != m_run.warnings().changes())
    m_now.warnings = std::make_shared<const std::vector<LatheWarning>>(m_run.warnings().all());
  m_state = std::make_shared<const LatheMoment>(m_now);
}

void LatheSimulation::finish() {
  m_sinceThreaded = std::numeric_limits<double>::infinity();
  publish();
}

}  // namespace handwheel
