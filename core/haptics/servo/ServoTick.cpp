// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/servo/ServoTick.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kLongestGap = 1.0;      // s: a longer one is the clock that jumped, or a machine that slept
constexpr double kLongestPeriods = 4.0;  // nominal periods, the most that a scene is told

double rateOf(const ServoSettings& settings, const DeviceCapabilities& device) {
  const double rate = settings.rate == 0.0 ? device.nominalRate : settings.rate;
  return rate > kLeastServoRate ? std::min(rate, kLargestServoRate) : kLeastServoRate;  // NaN, too
}

bool isReading(const DeviceState& state) {
  return state.status == DeviceStatus::Ready && state.position.allFinite() && state.orientation.coeffs().allFinite() &&
         state.orientation.norm() > 0.5 && std::isfinite(state.gripper) &&
         (!state.hasVelocity || state.velocity.allFinite());
}

}  // namespace

ServoTick::ServoTick(Device& device, const ServoSettings& settings, ServoClock& clock, ServoChannel& channel)
    : m_device(device),
      m_clock(clock),
      m_channel(channel),
      m_capabilities(device.capabilities()),
      m_chain(safetySettingsFor(m_capabilities, rateOf(settings, m_capabilities))),
      m_measure(m_capabilities, m_chain.settings().inherentDamping, m_chain.settings().nominalPeriod),
      m_motion(settings.velocityWindow,
               {nominalPeriod(), 1.0 / std::max(m_capabilities.nominalRate, 1.0), m_chain.settings().staleTime}) {
  m_mapper.setMapping({});
}

void ServoTick::run(std::int64_t now) noexcept {
  const double period = advance(now);
  ServoSample sample;
  sample.tick = m_tick++;
  sample.tip.time = m_time;  // also where no tip is known
  sample.device = m_device.read();

  SafetyInput input;
  input.period = period;
  input.isDiscontinuous = takeNews();
  sample.scene = m_sceneNumber;
  input.isDeviceReady = isReading(sample.device);
  if (input.isDeviceReady) {
    feel(sample, input, period);
  } else {
    m_motion.reset();
    m_isRestart = true;
  }
  m_wasReady = input.isDeviceReady;

  const SafetyOutput output = m_chain.process(input);
  m_device.write(output.sent);
  const double spent = static_cast<double>(m_clock.now() - now) / kNanoseconds;
  m_measure.addDelay(spent);
  sample.sent = output.sent;
  sample.actions = output.actions;
  sample.energy = output.energy;
  sample.microseconds = static_cast<float>(spent * 1e6);
  m_channel.samples.push(sample);
  m_channel.latest.write(sample);
}

void ServoTick::pause() noexcept {
  m_hasLast = false;
  m_isRestart = true;
  m_motion.reset();
  m_wasReady = false;
  SafetyInput gone;
  gone.isDeviceReady = false;
  m_chain.process(gone);
}

void ServoTick::resumeFrom(const ServoTick& before) {
  m_mapper = before.m_mapper;
  m_mappingNumber = before.m_mappingNumber;
  m_renderer = before.m_renderer;
  m_sceneNumber = before.m_sceneNumber;
  m_tick = before.m_tick;
  m_time = before.m_time;
}

// Returns the seconds since the last tick by the clock. A clock that stands still or goes back counts as a tick in
// time.
double ServoTick::advance(std::int64_t now) {
  const double nominal = nominalPeriod();
  const double gap = m_hasLast ? static_cast<double>(now - m_last) / kNanoseconds : nominal;
  m_last = now;
  if (m_hasLast) m_measure.addPeriod(gap);
  m_hasLast = true;
  const double period = gap > 0.0 ? gap : nominal;
  m_time += period < kLongestGap ? period : nominal;
  return period;
}

// Returns true if the force may leap with the new data. The owner announces a leap first, and hands over a scene before
// the mapping that it was made for; they are read in reverse order, so a tick that finds the later finds the earlier,
// too.
bool ServoTick::takeNews() {
  const NumberedMapping& requested = m_channel.mapping.read();
  const auto taken = m_channel.scenes.take();
  takeMapping(taken.isNew && taken.current->mapping.number > requested.number ? taken.current->mapping : requested);
  const bool isDiscontinuous = m_channel.isDiscontinuous.exchange(false, std::memory_order_acquire);
  if (!taken.isNew) return isDiscontinuous;
  m_renderer = taken.current->renderer.get();
  m_sceneNumber = taken.current->number;
  if (m_renderer && taken.previous && taken.previous->renderer) m_renderer->follow(*taken.previous->renderer);
  return isDiscontinuous || taken.current->isDiscontinuous;
}

void ServoTick::takeMapping(const NumberedMapping& newest) {
  if (newest.number <= m_mappingNumber) return;
  m_mappingNumber = newest.number;
  m_mapper.setMapping(newest.mapping, m_proxy);
  m_isMoved = true;
}

void ServoTick::feel(ServoSample& sample, SafetyInput& input, double period) {
  const DeviceState& device = sample.device;
  input.position = device.position;
  const DeviceMotionEstimator::Seen seen = m_motion.add(device, period);
  input.velocity = seen.velocity;
  input.stepSpeed = seen.stepSpeed;
  const double elapsed = std::min(period, kLongestPeriods * nominalPeriod());
  const WorkspaceMapper::Tip placed = m_mapper.map(device, input.velocity, elapsed);
  sample.tip = tipFor(device, placed, elapsed);
  m_isRestart = false;
  sample.felt.proxy = placed.position;
  input.isDiscontinuous = input.isDiscontinuous || placed.hasDiscontinuity || !m_wasReady || placed.isHeld != m_wasHeld;
  m_wasHeld = placed.isHeld;
  if (m_renderer) ask(sample, input);
  input.isFresh = input.isFresh && seen.isNew;
  m_proxy = sample.felt.proxy.allFinite() ? sample.felt.proxy : placed.position;
  input.isDiscontinuous = input.isDiscontinuous || isMoveFelt(input.asked);
  const bool isForceOn = m_channel.isForceOn.load(std::memory_order_relaxed);
  // While the clutch holds the tip, the force at its position would push the hand about.
  if (!isForceOn || placed.isHeld) input.asked = {};
  if (isForceOn && !m_wasForceOn) input.isDiscontinuous = true;
  m_wasForceOn = isForceOn;
}

// Returns true if another view has changed force or torque by more than may be felt at once. The hand has no part in
// it: in the tick that takes up a mapping the tip does not follow it, or has leapt.
bool ServoTick::isMoveFelt(const DeviceForce& asked) {
  constexpr double kFeltTurn = 0.025;  // share of the largest torque, like the threshold of force for usual devices
  const SafetySettings& safety = m_chain.settings();
  const double change = (asked.force - m_asked.force).norm(), turn = (asked.torque - m_asked.torque).norm();
  const bool isTurnFelt = safety.maxTorque > 0.0 && !(turn <= kFeltTurn * safety.maxTorque);
  const bool isFelt = m_isMoved && (isTurnFelt || !(change <= safety.rampThreshold));
  m_asked = asked;
  m_isMoved = false;
  return isFelt;
}

void ServoTick::ask(ServoSample& sample, SafetyInput& input) {
  m_renderer->tick(sample.tip, sample.felt);
  sample.hasSource = true;
  const WorkspaceMapping& mapping = m_mapper.mapping();
  input.asked = {mapping.deviceForce(sample.felt.force), mapping.deviceTorque(sample.felt.torque), sample.felt.gripper};
  input.isFresh = sample.felt.isFresh;
}

TipState ServoTick::tipFor(const DeviceState& device, const WorkspaceMapper::Tip& placed, double period) const {
  TipState tip;
  tip.position = placed.position;
  tip.orientation = placed.orientation;
  tip.velocity = placed.velocity;
  tip.gripper = device.gripper;
  tip.time = m_time;
  tip.period = period;
  const WorkspaceMapping& mapping = m_mapper.mapping();
  tip.stiffnessLimit = mapping.sceneStiffness(m_measure.stiffnessLimit());
  if (m_capabilities.outputs > 0) tip.dampingLimit = mapping.sceneStiffness(m_chain.settings().inherentDamping);
  tip.buttons = device.buttons;
  tip.isRestart = m_isRestart || placed.hasDiscontinuity;
  return tip;
}

}  // namespace handwheel
