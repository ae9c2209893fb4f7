// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/drilling/DrillSimulation.h"

#include "volume/drilling/DrillProgram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace handwheel {
namespace {

constexpr double kHeldNear = 24.0;  // voxels around the foremost point of the tool that a hand holds

std::shared_ptr<const DrillState> beginning(const ClayState& begin) {
  auto state = std::make_shared<DrillState>();
  state->volume = begin.volume;
  state->surface = begin.surface;
  state->mask = begin.mask;
  return state;
}

std::shared_ptr<const DrillState> beginning(const HybridPart& part) {
  auto state = std::make_shared<DrillState>();
  state->volume = part.left();
  state->surface = VolumeSurface(part.left(), {}, HybridPart::kTile);
  state->isExact = part.isExact();
  return state;
}

}  // namespace

Box boxOfTile(const DrillState& state, const VolumeSurface::Key& tile) {
  const VoxelIndex first = HybridPart::kTile * VoxelIndex(tile[2], tile[1], tile[0]);
  return {state.volume.centre(first), state.volume.centre(first + VoxelIndex::Constant(HybridPart::kTile))};
}

bool isBesidePath(const DrillState& state) {
  if (state.moments.empty() || !state.plan) return false;
  const DrillMoment& now = state.moments[state.moments.size() - 1];
  return now.isCutting && now.deviation > state.plan->tolerance;
}

DrillSimulation::DrillSimulation(const std::shared_ptr<const ClayState>& begin, const DrillSetup& setup,
                                 std::optional<DrillFeed> feed, std::shared_ptr<ClayChannel> channel,
                                 std::optional<DrillPlan> plan)
    : m_state(beginning(*begin)),
      m_volume(begin->volume),
      m_setup(setup),
      m_run(m_volume, setup),
      m_plan(std::move(plan)),
      m_feed(std::move(feed)),
      m_channel(std::move(channel)) {}

DrillSimulation::DrillSimulation(HybridPart part, const DrillSetup& setup, std::optional<DrillFeed> feed,
                                 std::shared_ptr<ClayChannel> channel)
    : m_state(beginning(part)),
      m_part(std::move(part)),
      m_setup(setup),
      m_run(*m_part, setup),
      m_feed(std::move(feed)),
      m_channel(std::move(channel)) {}

void DrillSimulation::step(double dt, std::span<const SimulationInput> inputs) {
  m_load = {};
  m_hasTicks = false;
  if (m_part && !m_feed && !inputs.empty()) holdNear(inputs.back());
  for (const SimulationInput& input : inputs) {
    if (input.gesture == 0) continue;
    if (m_feed) {
      if (!m_start && input.proxy.allFinite()) m_start = input.proxy;
      continue;
    }
    if (!m_begin) m_begin = input.tip.time;
    m_time = input.tip.time - *m_begin;
    goTo(input.proxy, input.tip.orientation * Vec3::UnitZ());
  }
  if (m_start) feedFor(dt);
  if (m_hasTicks) publish();
  if (m_isWritten) return;
  m_channel->patch.write({m_state, m_felt});
  m_isWritten = true;
}

// mm, of the depth at which it turns. Out to the start and back as G83 does, by the rapid feed of programs.
double DrillSimulation::targetOfPhase() const {
  if (m_phase == Phase::Retracting) return 0.0;
  if (m_phase == Phase::Returning) return std::max(0.0, m_pecked - DrillProgram::kPeckClearance);
  const bool hasPecks = m_feed->peck >= DrillFeed::kLeastPeck;
  return hasPecks ? m_pecked + m_feed->peck : std::numeric_limits<double>::infinity();
}

// Each turn is a position of its own, so that the full depth of a peck is drilled.
void DrillSimulation::feedFor(double dt) {
  const auto go = [&] { goTo(*m_start + m_depth * m_feed->direction, m_feed->axis); };
  go();
  while (!m_isHeld) {
    const double target = targetOfPhase(), left = target - m_depth;
    const double speed = m_phase == Phase::Feeding ? m_feed->speed : DrillProgram::kRapid;
    const double needed = std::abs(left) / speed;
    if (needed >= dt) {
      m_depth += std::copysign(speed * dt, left);
      break;
    }
    m_depth = target;
    m_time += needed;
    dt -= needed;
    if (m_phase == Phase::Feeding) m_pecked = m_depth;
    m_phase = m_phase == Phase::Feeding      ? Phase::Retracting
              : m_phase == Phase::Retracting ? Phase::Returning
                                             : Phase::Feeding;
    go();
  }
  m_time += dt;
}

// Uses the pose of the record, so that the record gives the same hole. Beyond the limit of a record, drilling continues
// without it.
void DrillSimulation::goTo(const Vec3& position, const Vec3& axis) {
  const DrillPose pose = DrillPose::of(position, axis, m_time);
  if (!position.allFinite() || !pose.isSound()) return;
  const DrillTick tick = move(m_run, pose);
  m_load.thrust = std::max(m_load.thrust, tick.thrust);
  m_load.torque = std::max(m_load.torque, tick.torque.norm());
  m_hasTicks = true;
  watchLoad(tick, pose.direction());
  if (m_poses.size() == DrillRecord::kMostPoses) return;
  if (!m_watch) {
    const Vec3 along = pose.direction();
    if (!m_plan) {
      constexpr double kAnywhere = std::numeric_limits<double>::infinity();
      const Vec3 direction = m_feed ? m_feed->direction : Vec3(-along);
      m_plan = DrillPlan{pose.position() + m_setup.tool.edge() * direction, direction, kAnywhere, {}};
    }
    m_watch.emplace(*m_plan);
    m_watch->beginHole(m_setup);
  }
  m_poses.push_back(pose);
  m_moments.push_back(m_watch->add(tick, pose.direction(), m_run.breakthrough().has_value()));
}

// Computes the load by the balance of energy over the last stretch that is long enough for the resolution of the
// voxels.
void DrillSimulation::watchLoad(const DrillTick& tick, const Vec3& axis) {
  constexpr double kLeastTravel = 0.01;  // voxels
  const std::optional<DrillTick> before = std::exchange(m_before, tick);
  if (!before) return;
  const Vec3 displacement = tick.position - before->position;
  m_passage.displacement += displacement;
  m_passage.length += displacement.norm();
  m_passage.seconds += tick.time - before->time;
  m_passage.removed += tick.removed;
  if (!(m_passage.length > kLeastTravel * m_state->volume.voxel() && m_passage.seconds > 0.0)) return;
  const Passage gone = std::exchange(m_passage, {});
  const double feed = gone.length / gone.seconds;
  const DrillLoad load = drillLoad(m_setup.material, m_setup.tool, gone.removed, gone.seconds, feed, m_setup.spindle);
  m_felt.emplace();
  if (!(load.thrust > 0.0) || gone.displacement.isZero(0.0)) return;
  m_felt->resistance = load.thrust / feed;
  m_felt->direction = gone.displacement.normalized();
  m_felt->torque = -std::copysign(load.torque / load.thrust, m_setup.spindle) * axis;
}

// Cuts voxels ahead of the hand, which never waits. Voxels that it does not reach are given back.
void DrillSimulation::holdNear(const SimulationInput& hand) {
  const Vec3 foremost = hand.proxy - m_setup.tool.reach() * (hand.tip.orientation * Vec3::UnitZ());
  if (hand.isEnd || !foremost.allFinite()) return;
  const Vec3 near = Vec3::Constant(kHeldNear * m_part->left().voxel());
  if (!m_part->hold(Box(foremost - near, foremost + near))) return;
  m_part->make({});
  auto state = std::make_shared<DrillState>(*m_state);
  state->volume = m_part->left();
  state->isExact = m_part->isExact();
  m_state = std::move(state);
  m_isWritten = false;
}

// Whole tiles, as the triangles are hidden by tiles. Normals at their sides need the samples beside them.
void DrillSimulation::showTiles(DrillState& state, std::span<const VoxelIndex> changed) {
  std::vector<VolumeSurface::Key> touched = state.surface.piecesOf(changed, false);
  m_tiles.insert(touched.begin(), touched.end());
  touched = state.surface.piecesOf(changed, true);
  std::erase_if(touched, [this](const VolumeSurface::Key& tile) { return !m_tiles.contains(tile); });
  std::set<VolumeSurface::Key> needed;
  for (const VolumeSurface::Key& tile : touched)
    for (int k = 0; k < 27; ++k) needed.insert({tile[0] + k / 9 - 1, tile[1] + k / 3 % 3 - 1, tile[2] + k % 3 - 1});
  std::vector<VoxelIndex> tiles;
  tiles.reserve(needed.size());
  for (const VolumeSurface::Key& tile : needed) tiles.emplace_back(tile[2], tile[1], tile[0]);
  m_part->makeAlso(tiles);
  state.surface.make(m_part->left(), touched);
  state.tiles.assign(m_tiles.begin(), m_tiles.end());
  state.isExact = m_part->isExact();
}

void DrillSimulation::publish() {
  const std::vector<VoxelIndex> changed = m_run.takeChangedBlocks();
  for (const VoxelIndex& block : changed) m_changed.insert({block.x(), block.y(), block.z()});
  auto state = std::make_shared<DrillState>(*m_state);
  if (m_part) {
    showTiles(*state, changed);
    state->volume = m_part->left();
  } else {
    state->surface.update(m_volume, changed);
    state->volume = m_volume;
  }
  state->changedBlocks = m_changed.size();
  state->thrust = m_load.thrust;
  state->torque = m_load.torque;
  state->removed = m_run.removed();
  state->energy = m_run.energy();
  state->time = m_time;
  state->breakthrough = m_run.breakthrough();
  if (m_watch) {
    state->plan = m_watch->plan();
    state->figures = m_watch->figures();
  }
  state->moments = m_moments;
  state->poses = m_poses;
  m_state = std::move(state);
  m_isWritten = false;
}

}  // namespace handwheel
