// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheMachine.h"

#include "machining/lathe/LatheWarnings.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kMostLead = 100.0;  // mm in a turn; limit of feed and lead
constexpr std::size_t kCarriage = static_cast<std::size_t>(LatheAxis::Carriage);
constexpr std::size_t kCross = static_cast<std::size_t>(LatheAxis::Cross);

int signOf(double value) {
  return value > 0.0 ? 1 : value < 0.0 ? -1 : 0;
}

}  // namespace

LatheMachine::LatheMachine(LatheSetup setup, const LatheState& state) : m_setup(std::move(setup)), m_state(state) {
  assert(m_setup.isSound());
  m_state.tool = std::min<std::uint32_t>(m_state.tool, static_cast<std::uint32_t>(m_setup.stations.size() - 1));
}

LatheState LatheMachine::initialState(const LatheSetup& setup, const StockCylinder& stock) {
  constexpr double kAway = 20.0;  // mm
  LatheState state;
  state.wheels[kCarriage] = stock.length + kAway;
  state.wheels[kCross] = 0.5 * stock.diameter + kAway;
  for (std::size_t i = 0; i < kLatheAxes; ++i)
    state.wheels[i] = std::clamp(state.wheels[i], setup.dials[i].least, setup.dials[i].largest);
  state.slides = state.wheels;
  state.setSpeed = std::clamp(setup.spindle.speed, setup.spindle.leastSpeed, setup.spindle.largestSpeed);
  return state;
}

void LatheMachine::apply(const LatheCommand& command) {
  if (!std::isfinite(command.value) || !std::isfinite(command.other)) return;
  const std::size_t axis = static_cast<std::size_t>(command.axis);
  switch (command.kind) {
    case LatheCommand::Kind::Turn:
      m_state.demands[axis] += command.value;
      break;
    case LatheCommand::Kind::MoveTip: {
      const ProfilePoint displacement = ProfilePoint(command.value, command.other) - tip();
      m_state.demands[kCross] = displacement.x();
      m_state.demands[kCarriage] = displacement.y();
      break;
    }
    case LatheCommand::Kind::Release:
      m_state.demands.fill(0.0);
      break;
    case LatheCommand::Kind::Rapid:
      m_state.rapids[axis] = signOf(command.value);
      break;
    case LatheCommand::Kind::Spindle:
      m_state.direction = signOf(command.value);
      break;
    case LatheCommand::Kind::Speed:
      m_state.surfaceSpeed = 0.0;
      m_state.setSpeed = std::clamp(command.value, m_setup.spindle.leastSpeed, m_setup.spindle.largestSpeed);
      break;
    case LatheCommand::Kind::SurfaceSpeed:
      m_state.surfaceSpeed = std::max(0.0, command.value);
      m_state.speedClamp = std::max(0.0, command.other);
      break;
    case LatheCommand::Kind::Feed:
      if (command.axis != LatheAxis::Carriage && command.axis != LatheAxis::Cross) break;
      m_state.feedAxis = command.axis;
      m_state.feed = std::clamp(command.value, -kMostLead, kMostLead);
      break;
    case LatheCommand::Kind::HalfNut:
      m_state.lead = std::clamp(command.value, -kMostLead, kMostLead);
      m_state.isNutClosed = false;
      break;
    case LatheCommand::Kind::Tool:
      if (command.value >= 0.0 && command.value < static_cast<double>(m_setup.stations.size()))
        m_state.tool = static_cast<std::uint32_t>(command.value);
      break;
  }
}

// v = π d n. At the axis only the clamp holds.
double LatheMachine::targetSpeed() const {
  const LatheSpindle& spindle = m_setup.spindle;
  if (m_state.direction == 0) return 0.0;
  double speed = m_state.setSpeed;
  if (m_state.surfaceSpeed > 0.0) {
    const double around = 2.0 * M_PI * std::abs(tip().x()) / 1000.0;  // m
    speed = around > 0.0 ? m_state.surfaceSpeed / around : spindle.largestSpeed;
    if (m_state.speedClamp > 0.0) speed = std::min(speed, m_state.speedClamp);
    speed = std::clamp(speed, std::min(spindle.leastSpeed, speed), spindle.largestSpeed);
  }
  return m_state.direction * speed;
}

void LatheMachine::turnWheel(LatheAxis axis, double by) {
  const std::size_t i = static_cast<std::size_t>(axis);
  const LatheDial& dial = m_setup.dials[i];
  const double play = 0.5 * dial.backlash;
  double& wheel = m_state.wheels[i];
  double& slide = m_state.slides[i];
  wheel = std::clamp(wheel + by, dial.least - play, dial.largest + play);
  slide = std::clamp(std::clamp(slide, wheel - play, wheel + play), dial.least, dial.largest);
}

// Moves a slide by its drive, which also turns the wheel.
void LatheMachine::moveSlide(LatheAxis axis, double by) {
  const std::size_t i = static_cast<std::size_t>(axis);
  const double before = m_state.slides[i];
  m_state.slides[i] = std::clamp(before + by, m_setup.dials[i].least, m_setup.dials[i].largest);
  m_state.wheels[i] += m_state.slides[i] - before;
}

// before: turns of the spindle before this step. The screw has turned by lead · turns; its threads are a pitch apart.
void LatheMachine::followNut(double before) {
  if (m_state.lead == 0.0) return;
  const double here = m_state.slides[kCarriage], pitch = m_setup.leadScrewPitch;
  if (!m_state.isNutClosed) {
    const double was = (here - m_state.lead * before) / pitch, is = (here - m_state.lead * m_state.turns) / pitch;
    const double thread = was < is ? std::floor(is) : std::ceil(is);
    if (was == is || (was < is ? thread < was : thread > was)) return;
    m_state.isNutClosed = true;
    m_state.nutPosition = thread * pitch;
  }
  moveSlide(LatheAxis::Carriage, m_state.nutPosition + m_state.lead * m_state.turns - here);
}

// The setup's acceleration is that of a free spindle with the full torque of the drive.
double LatheMachine::nextSpeed(double dt, double torque) const {
  const double speed = m_state.speed, target = targetSpeed(), ramp = m_setup.spindle.acceleration * dt;
  const bool isDriven = speed * target > 0.0 && std::abs(speed) <= std::abs(target);
  const double left = isDriven ? 1.0 - torque / spindleTorque(m_setup.spindle, speed) : 1.0;
  if (left < 0.0) return speed - std::copysign(std::min(std::abs(speed), -left * ramp), speed);
  return speed + std::clamp(target - speed, -left * ramp, left * ramp);
}

// Returns the share of the remaining travel that the hands can make without moving a slide or the tool by more than
// this, mm: two wheels at once do not go through material faster than one.
double LatheMachine::shareOfHands(double most) const {
  const std::array<double, kLatheAxes> none{};
  double longest = (tipAt(m_setup, slot(), m_state.demands) - tipAt(m_setup, slot(), none)).norm();
  for (const double demand : m_state.demands) longest = std::max(longest, std::abs(demand));
  return longest > most ? most / longest : 1.0;
}

LatheMotion LatheMachine::advance(double dt, double mostByHand, double torque) {
  LatheMotion motion;
  m_state.speed = nextSpeed(dt, torque);
  const double before = m_state.turns, turned = m_state.speed / 60.0 * dt;
  m_state.turns += turned;
  m_state.time += dt;
  motion.turns = std::abs(turned);
  const double share = shareOfHands(mostByHand);
  for (std::size_t i = 0; i < kLatheAxes; ++i) {
    const LatheAxis axis = static_cast<LatheAxis>(i);
    const double byHand = share * m_state.demands[i];
    m_state.demands[i] -= byHand;
    if (byHand != 0.0) turnWheel(axis, byHand);
    motion.isByHand = motion.isByHand || byHand != 0.0;
    if (m_state.rapids[i] == 0) continue;
    moveSlide(axis, m_state.rapids[i] * m_setup.rapidSpeed * dt);
    motion.isRapid = true;
  }
  if (m_state.feed != 0.0 && m_state.lead == 0.0) moveSlide(m_state.feedAxis, m_state.feed * motion.turns);
  followNut(before);
  return motion;
}

void LatheMachine::stop() {
  m_state.demands.fill(0.0);
  m_state.rapids.fill(0);
  m_state.direction = 0;
  m_state.speed = 0.0;
  m_state.feed = 0.0;
  m_state.lead = 0.0;
  m_state.isNutClosed = false;
}

// The quill extends towards the chuck.
double LatheMachine::quillTip() const {
  return m_setup.tailstock.position - m_state.slides[static_cast<std::size_t>(LatheAxis::Quill)];
}

}  // namespace handwheel
