// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramMachine.h"

#include <cmath>

namespace handwheel {

namespace {

constexpr double kFarthest = 1e6;  // mm: no machine is larger
constexpr const char* kSpindleRemedy = "Write a speed and M3 or M4 before it, such as S500 M3.";

}  // namespace

ProgramMachine::ProgramMachine(const ProgramSetup& setup, ToolPath& path)
    : m_setup(setup),
      m_path(path),
      m_compensation(setup.dialect, [this](const NoseCompensation::Step& step) { emitStep(step); }) {
  m_systems.fill(-setup.reference);
  m_at = m_tip = setup.reference;
}

ToolMove ProgramMachine::moveOf(ToolMove::Kind kind, double length, const SourceLocation& location) const {
  ToolMove move;
  move.kind = kind;
  move.line = location.line;
  move.tool = static_cast<std::uint16_t>(modal.tool);
  move.shape = static_cast<std::uint16_t>(mounted());
  move.spin = static_cast<std::int8_t>(modal.spin);
  move.isStoppedByChange = modal.spin == 0 && modal.isStoppedByChange;
  move.isSurfaceSpeed = modal.isSurfaceSpeed;
  move.spindle = modal.spindle;
  move.mostSpindle = modal.mostSpindle;
  if (kind != ToolMove::Kind::Feed) return move;
  move.feed = modal.feedMode == FeedMode::InverseTime ? modal.feed * length : modal.feed;
  move.isPerRevolution = modal.feedMode == FeedMode::PerRevolution;
  if (!(modal.feed > 0.0)) refuse(location, "F", "there is no feed rate", "Write one before this move, such as F100.");
  if (move.isPerRevolution && !(modal.spindle > 0.0))
    refuse(location, "F", "a feed per revolution needs a turning spindle", kSpindleRemedy);
  return move;
}

void ProgramMachine::straight(ToolMove::Kind kind, const ProfilePoint& to, const SourceLocation& location) {
  m_needsStraight = false;
  go({moveOf(kind, (to - m_tip).norm(), location), planePoint(to), {}, location});
}

void ProgramMachine::arc(int turn, const ProfilePoint& to, const ProfilePoint& centre, const SourceLocation& location) {
  if (m_needsStraight)
    refuse(location, turn > 0 ? "G3" : "G2", "the move after nose compensation must be straight",
           "Put a straight move before the arc.");
  ToolMove length;
  length.turn = static_cast<std::int8_t>(turn);
  length.from = m_tip;
  length.to = to;
  length.centre = centre;
  ToolMove move = moveOf(ToolMove::Kind::Feed, lengthOf(length), location);
  move.turn = length.turn;
  go({move, planePoint(to), planePoint(centre), location});
}

void ProgramMachine::thread(const ProfilePoint& to, double pitch, const SourceLocation& location) {
  if (modal.spin == 0 || !(modal.spindle > 0.0))
    refuse(location, "thread", "the spindle does not turn", kSpindleRemedy);
  if (isCompensated())
    refuse(location, "thread", "a thread cannot be cut with nose compensation", "Write G40 before it.");
  ToolMove move = moveOf(ToolMove::Kind::Thread, 0.0, location);
  move.feed = pitch;
  move.isPerRevolution = true;
  go({move, planePoint(to), {}, location});
}

void ProgramMachine::dwell(double seconds, const SourceLocation& location) {
  if (!(seconds >= 0.0 && seconds <= 1e5))
    refuse(location, "G4", "the dwell is not between 0 and 100000 s", "Correct its time.");
  ToolMove move = moveOf(ToolMove::Kind::Dwell, 0.0, location);
  move.time = seconds;
  move.from = move.to = partPoint(m_tip);
  m_path.moves.push_back(move);
  m_path.time += seconds;
}

void ProgramMachine::go(const NoseCompensation::Step& step) {
  const ProfilePoint to = profilePoint(step.to);
  if (!(to.cwiseAbs().maxCoeff() <= kFarthest))
    refuse(step.location, "X Z", "the place is farther away than 1000 m", "Check the numbers of the move.");
  if (m_compensation.isOn())
    m_compensation.move(step);
  else
    emitStep(step);
  m_at = to;
}

void ProgramMachine::emitStep(const NoseCompensation::Step& step) {
  if (m_path.moves.size() >= m_setup.mostMoves)
    throw ProgramRefusal{
        {ProgramError::TooManyMoves, {std::to_string(m_setup.mostMoves)}, InputPosition::line(step.location.line), {}}};
  ToolMove move = step.modal;
  const ProfilePoint to = profilePoint(step.to);
  move.from = partPoint(m_tip);
  move.to = partPoint(to);
  move.centre = partPoint(profilePoint(step.centre));
  m_tip = to;
  if (move.turn == 0 && move.from == move.to) return;
  move.time = durationOf(move, m_setup.rapidSpeed);
  m_path.time += move.time;
  m_path.moves.push_back(move);
}

void ProgramMachine::compensate(int side, double radius, const ProfilePoint& tip, const SourceLocation& location) {
  if (m_compensation.isOn())
    refuse(location, side > 0 ? "G41" : "G42", "nose compensation is on already", "Write G40 before it.");
  if (radius > 0.0) m_compensation.begin(side, radius, tip, planePoint(m_tip), modal.isInch);
}

void ProgramMachine::endCompensation() {
  if (!m_compensation.isOn()) return;
  m_compensation.end();
  m_needsStraight = true;
}

void ProgramMachine::selectSystem(int index) {
  const ProfilePoint change = m_systems[m_system] - m_systems[index];
  m_at += change;
  m_tip += change;
  m_system = index;
}

void ProgramMachine::setSystem(int index, const ProfilePoint& offset) {
  if (index == m_system) {
    m_at += m_systems[index] - offset;
    m_tip += m_systems[index] - offset;
  }
  m_systems[index] = offset;
}

void ProgramMachine::setShift(const ProfilePoint& shift) {
  m_at += m_shift - shift;
  m_tip += m_shift - shift;
  m_shift = shift;
}

void ProgramMachine::changeTool(int number) {
  if (number != modal.tool) m_path.time += m_setup.toolChange;
  modal.tool = number;
}

// Returns the entry of the mounted tool, or that of the offset in effect: on a Fanuc a tool may have an offset of
// another number.
int ProgramMachine::mounted() const {
  const bool isThere = m_setup.tools.contains(modal.tool) || !m_setup.tools.contains(m_offsetNumber);
  return isThere ? modal.tool : m_offsetNumber;
}

ProfilePoint ProgramMachine::tipOffset() const {
  const auto found = m_setup.tools.find(modal.tool);
  return found == m_setup.tools.end() ? m_toolOffset : found->second.offset;
}

void ProgramMachine::setToolOffset(const ProfilePoint& offset, int number) {
  m_offsetNumber = number;
  m_at += m_toolOffset - offset;
  m_tip += m_toolOffset - offset;
  m_toolOffset = offset;
}

}  // namespace handwheel
