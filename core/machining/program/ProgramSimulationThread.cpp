// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The moves of a program that cut threads.
#include "machining/program/ProgramSimulation.h"

#include "machining/thread/ThreadChip.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSameLength = 1e-6;  // mm

}  // namespace

// A spiral on a face has no groove along the axis, and a pitch finer than any thread is a feed: both are cut like any
// other move.
bool ProgramSimulation::isThread(const ToolMove& move) {
  const double along = std::abs(move.to.y() - move.from.y()), length = lengthOf(move);
  if (move.kind != ToolMove::Kind::Thread || !(along > 1e-3 * length)) return false;
  const double pitch = move.feed * along / length;
  return pitch >= ThreadCut::kLeastPitch && pitch <= ThreadCut::kLargestPitch &&
         along / pitch <= ThreadGroove::kMostTurns;
}

// A tool is drawn back out of its groove, between the flanks and away from the material.
bool ProgramSimulation::leavesThread(const ToolMove& move) const {
  if (!m_state.lead || move.turn != 0 || m_state.lead->end != move.from) return false;
  const ProfilePoint displacement = move.to - move.from;
  const double away = m_state.lead->side == TurningSide::Bore ? -displacement.x() : displacement.x();
  return std::abs(displacement.y()) <= away * std::tan(0.5 * ThreadCut().angle) + kSameLength;
}

// The work turns opposite to the tool: if the spindle runs forward and the tool goes towards the chuck, the thread is
// right-hand. The first move of several begins in the half plane of +x.
TurningPass ProgramSimulation::threadOf(const ToolMove& move) const {
  const ProgramTool& tool = m_setup.toolOf(move);
  const double nose = tool.noseRadius;
  const ProfilePoint shift = ProfilePoint(0.0, zeroHeight()) - nose * tipOf(move);
  const double travel = move.to.y() - move.from.y();
  TurningPass pass;
  pass.isOfProgram = true;
  pass.noseRadius = nose;
  pass.path = {move.from + shift, move.to + shift};
  pass.times = {0.0, move.time};
  const ProfilePoint middle = 0.5 * (pass.path[0] + pass.path[1]);
  pass.speeds.assign(2, move.spin == 0 ? 0.0 : spindleAt(move, pointOn(move, 0.5).x()));
  const double at = std::clamp(middle.y() / m_part.spacing(), 0.0, static_cast<double>(m_part.size() - 1));
  const auto sample = static_cast<std::size_t>(at);
  const double bore = m_part.inner(sample);
  if (bore > 0.0 && middle.x() - bore < m_part.radius(sample) - middle.x()) pass.side = TurningSide::Bore;
  ThreadCut thread;
  thread.pitch = move.feed * std::abs(travel) / lengthOf(move);
  const double forward = move.spin < 0 ? -1.0 : 1.0;
  thread.isLeft = travel * forward > 0.0;
  const double turned = m_state.lead ? -forward * m_state.lead->turns : 0.0;  // turns of the tool about the work
  const double offset = pass.path[0].y() - thread.rise() * turned;
  thread.offset = offset - thread.pitch * std::floor(offset / thread.pitch);
  pass.thread = thread;
  return pass;
}

// Consecutive moves are one pass if they continue with the same lead.
void ProgramSimulation::cutThread(const ToolMove& move) {
  endPass();
  std::optional<ThreadLead>& lead = m_state.lead;
  if (lead && lead->end != move.from) lead.reset();
  TurningPass pass = threadOf(move);
  const TurningSide side = pass.side;
  meetChuck(move, pass.noseRadius, side, pass.path.back());
  const std::vector<ThreadGroove> grooves = ThreadGroove::of(pass);
  if (!grooves.empty() && grooves.front().touches(m_part)) {
    m_state.threads = PartThreads::with(m_state.threads, pass);
    const bool goesOn = lead && !m_passes.empty() && m_passes.back().thread && m_passes.back().side == side &&
                        m_passes.back().path.back() == pass.path.front() &&
                        std::abs(m_passes.back().thread->pitch - pass.thread->pitch) < kSameLength &&
                        m_passes.back().thread->isLeft == pass.thread->isLeft;
    if (goesOn) {
      m_passes.back().path.push_back(pass.path.back());
      m_passes.back().times.push_back(std::max(m_time - m_passBegin, m_passes.back().times.back()));
      m_passes.back().speeds.push_back(pass.speeds.back());
    } else {
      m_passBegin = m_time - move.time;
      m_passes.push_back(std::move(pass));
    }
  }
  const double turns = lead ? lead->turns : 0.0;
  lead = ThreadLead{move.to, turns + lengthOf(move) / move.feed, side};
}

}  // namespace handwheel
